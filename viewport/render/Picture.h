#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/Image.h"
#include "viewport/render/Renderer.h"

namespace rubble {

/// The largest side of a picture, pixels.
inline constexpr int kLargestPicture = 8192;

/// A scene as a picture, drawn without a display. `samples`: 0 for what the editor shows at once, else the number whose
/// mean is taken for soft light and smooth edges.
///
/// Errors: those of SurfacelessContext::made() and Renderer::made(); BadInput where a side is less than 1 or greater than
/// kLargestPicture; Cancelled.
Result<Image> pictureOf(std::shared_ptr<const RenderScene> scene, const PictureView& view, int samples,
                        const TaskContext& task = {});

}  // namespace rubble
