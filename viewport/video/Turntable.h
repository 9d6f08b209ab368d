#pragma once

#include "viewport/video/FrameSource.h"

namespace rubble {

/// The pictures of a scene from all around: the camera of `view` goes once around its target, to the right, in equal
/// steps. `samples`: see renderImage().
FrameSource turntable(std::shared_ptr<const RenderScene> scene, const RenderView& view, int frames, int samples);

}  // namespace rubble
