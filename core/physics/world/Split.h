#pragma once

#include "core/physics/state/WorldState.h"

#include <span>
#include <vector>

namespace rubble {

/// A body that another one falls apart into.
struct SplitPart {
    std::shared_ptr<const Shape> shape;
    Vec3 offset{0.0, 0.0, 0.0};  // m: of the shape's frame in that of the body that splits; the axes are the same
    /// For each hull of the shape, the hull of the body that it was, whose contacts it keeps; kNone: a new one.
    std::vector<std::uint32_t> hulls;
    BodyKind kind = BodyKind::Dynamic;
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s, of the centre of mass
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s, in world axes
    BodyMaterial material;
    std::uint64_t tag = 0;
};

/// Why a part cannot be a body, as a sentence; nothing for a valid one.
std::optional<std::string> verifyPart(const SplitPart& part);

/// See World::split(). Returns the indices of the bodies.
std::vector<std::uint32_t> splitBody(WorldState& state, std::uint32_t body, std::span<const SplitPart> parts);

}  // namespace rubble
