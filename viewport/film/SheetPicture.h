#pragma once

#include "core/play/ContactSheet.h"
#include "viewport/render/Picture.h"
#include "viewport/scene/SceneBuilder.h"

namespace rubble {

/// How the variants of a sheet are drawn: all in the same way, so that they can be compared.
struct SheetLook {
    PictureSize size{320, 240};  // of one picture
    Theme theme = Theme::Light;
    StandardView view = StandardView::Isometric;
    SceneColouring colouring = SceneColouring::Piece;
    int samples = 4;  // see pictureOf()
    bool operator==(const SheetLook&) const = default;
};

/// Draws the variants of one sheet, one after another, without a display. In the thread that made it.
class SheetPainter {
public:
    /// What the camera shows is the same for all. Where variants are played, it is the instance nearest to the first shot, with room
    /// for what falls off it, seen from beside whoever throws; else the asset by itself, in parallel projection.
    ///
    /// Errors: those of PictureMaker::made().
    static Result<SheetPainter> made(const SheetOrder& order, const SheetLook& look);

    /// A variant at its step, or its pieces at rest. Its moment may be let go of then.
    ///
    /// Errors: BadInput, with its own sentence, where the entry has a fault; those of PictureMaker.
    Result<Image> pictureOf(const SheetEntry& entry, const TaskContext& task = {});

private:
    SheetPainter(PictureMaker maker, const SheetOrder& order, const SheetLook& look);

    PictureMaker m_maker;
    Project m_project;
    SheetLook m_look;
    PictureView m_view;
};

/// Makes a sheet and draws it as it is made: bakes and plays on threads of their own, pictures in the caller's. Hands each variant
/// over with its picture, none where it has a fault, in any order and in the caller's thread; its moment was let go of.
///
/// Errors: those of SheetPainter and of makeContactSheet(); Cancelled.
Status drawContactSheet(const SheetOrder& order, const SheetLook& look,
                        const std::function<void(SheetEntry, std::optional<Image>)>& take,
                        const TaskContext& task = {});

}  // namespace rubble
