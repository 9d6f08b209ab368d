#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/Image.h"
#include "viewport/render/Renderer.h"
#include "viewport/render/SurfacelessContext.h"

namespace rubble {

/// The largest side of a picture, pixels.
inline constexpr int kLargestPicture = 8192;

/// Draws pictures without a display, one after another: what they share is made once. In the thread that made it.
class PictureMaker {
public:
    /// Errors: those of SurfacelessContext::made() and Renderer::made().
    static Result<PictureMaker> made();

    /// The same as below.
    Result<Image> pictureOf(std::shared_ptr<const RenderScene> scene, const PictureView& view, int samples,
                            const TaskContext& task = {});

private:
    PictureMaker(std::unique_ptr<SurfacelessContext> context, std::unique_ptr<Renderer> renderer);

    std::unique_ptr<SurfacelessContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

/// A scene as a picture, drawn without a display. `samples`: 0 for what the editor shows at once, else the number whose
/// mean is taken for soft light and smooth edges.
///
/// Errors: those of SurfacelessContext::made() and Renderer::made(); BadInput where a side is less than 1 or greater than
/// kLargestPicture; Cancelled.
Result<Image> pictureOf(std::shared_ptr<const RenderScene> scene, const PictureView& view, int samples,
                        const TaskContext& task = {});

}  // namespace rubble
