#pragma once

#include "viewport/scene/RenderScene.h"

#include <memory>
#include <vector>

namespace rubble {

/// A visible body of a scene.
struct ShownBody {
    std::uint32_t body = 0;  // its index in the scene
    RenderPose pose;
    bool operator==(const ShownBody&) const = default;
};

/// A moment of a session as it is drawn without overlays and without what flies for a while after an event: what
/// differs from moment to moment, beside what many of them share.
struct SessionMoment {
    std::shared_ptr<const RenderScene> layout;  // all bodies, hidden, without poses
    std::vector<ShownBody> bodies;              // ascending
    std::vector<SceneLine> lines;               // cracks
    std::vector<SurfaceMark> marks;
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s²
};

}  // namespace rubble
