#pragma once

namespace rubble {

/// When a 3D view accumulates samples for soft light and smooth edges while nothing changes.
enum class ProgressiveRendering { Never, WithGpu, Always };  // WithGpu: not with a software rasterizer

}  // namespace rubble
