#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/Image.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/gl/SurfacelessContext.h"

namespace rubble {

/// The largest side of an image, pixels.
inline constexpr int kMaxImageSide = 8192;

/// Renders images without a display, one after another, and reuses shared resources. Used only in the thread that
/// created it.
class OffscreenRenderer {
public:
    /// Errors: see SurfacelessContext::create() and Renderer::create().
    static Result<OffscreenRenderer> create();

    /// See renderImage() below.
    Result<Image> renderImage(std::shared_ptr<const RenderScene> scene, const RenderView& view, int samples,
                              const TaskContext& task = {});
    /// The bodies alone, with opacities, without sky and ground: see cutOut().
    Result<Image> renderCutOut(const std::shared_ptr<const RenderScene>& scene, RenderView view, int samples,
                               const TaskContext& task = {});

private:
    OffscreenRenderer(std::unique_ptr<SurfacelessContext> context, std::unique_ptr<Renderer> renderer);

    std::unique_ptr<SurfacelessContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

/// Renders a scene to an image without a display. `samples`: 0 for one pass as in the editor while navigating;
/// otherwise the number of samples that are averaged for soft light and smooth edges.
///
/// Errors: see SurfacelessContext::create() and Renderer::create(); BadInput if a side is less than 1 or greater than
/// kMaxImageSide; Cancelled.
Result<Image> renderImage(std::shared_ptr<const RenderScene> scene, const RenderView& view, int samples,
                          const TaskContext& task = {});

}  // namespace rubble
