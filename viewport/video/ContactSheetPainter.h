#pragma once

#include "core/play/analysis/ContactSheet.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/SceneBuilder.h"

namespace rubble {

/// The style in which the variants of a contact sheet are drawn; the same for all, so that they can be compared.
struct SheetStyle {
    ImageSize size{320, 240};  // of one image
    Theme theme = Theme::Light;
    StandardView view = StandardView::Isometric;
    SceneColouring colouring = SceneColouring::Fragment;
    int samples = 4;  // see renderImage()
    bool operator==(const SheetStyle&) const = default;
};

/// Renders the variants of one contact sheet, one after another, without a display. Used only in the thread that
/// created it.
class ContactSheetPainter {
public:
    /// Uses one camera for all variants. If they are played, it shows the instance nearest to the first shot, with
    /// space for falling debris, from beside the shot's origin; otherwise the asset by itself in parallel projection.
    ///
    /// Errors: see OffscreenRenderer::create().
    static Result<ContactSheetPainter> create(const SheetRequest& request, const SheetStyle& style);

    /// A variant at its step, or its solids at rest. Its session is not needed afterwards.
    ///
    /// Errors: BadInput, with the entry's message, if the entry has an error; see OffscreenRenderer.
    Result<Image> renderImage(const SheetEntry& entry, const TaskContext& task = {});

private:
    ContactSheetPainter(OffscreenRenderer renderer, const SheetRequest& request, const SheetStyle& style);

    OffscreenRenderer m_renderer;
    Project m_project;
    SheetStyle m_style;
    RenderView m_view;
};

/// Generates a contact sheet: bakes and plays in worker threads, renders in the caller's. Calls `take` there with each
/// variant and its image, none if it has an error, in any order; its session is already released.
///
/// Errors: those of ContactSheetPainter and of makeContactSheet(); Cancelled.
Status drawContactSheet(const SheetRequest& request, const SheetStyle& style,
                        const std::function<void(SheetEntry, std::optional<Image>)>& take,
                        const TaskContext& task = {});

}  // namespace rubble
