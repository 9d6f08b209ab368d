#pragma once

#include "core/asset/project/Project.h"

#include <variant>

namespace rubble {

/// Throws a projectile, strikes with a hammer, or sets off a blast.
struct ShotInput {
    std::string name;
    ShotAction action;
    bool operator==(const ShotInput&) const = default;
};
/// Changes the threshold of an asset, or of one instance.
struct ThresholdInput {
    Id asset = 0;
    Id instance = 0;         // instead of the asset unless 0
    double threshold = 0.0;  // N·s, > 0
    bool operator==(const ThresholdInput&) const = default;
};
/// Changes the values of the material with this id.
struct MaterialInput {
    Material material;
    bool operator==(const MaterialInput&) const = default;
};
/// Breaks a body without any force.
struct BreakInput {
    std::uint32_t body = 0;  // its number
    bool operator==(const BreakInput&) const = default;
};
struct GravityInput {
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s²
    bool operator==(const GravityInput&) const = default;
};
/// Enables or disables breaking.
struct DestructionInput {
    bool isOn = true;
    bool operator==(const DestructionInput&) const = default;
};
/// Grabs a point of a body.
struct GrabInput {
    std::uint32_t body = 0;     // its number
    Vec3 point{0.0, 0.0, 0.0};  // m, in the world
    double force = 0.0;         // N, maximum
    bool operator==(const GrabInput&) const = default;
};
/// Drags the grabbed point.
struct DragInput {
    Vec3 to{0.0, 0.0, 0.0};  // m
    bool operator==(const DragInput&) const = default;
};
/// Releases the grabbed point.
struct ReleaseInput {
    bool operator==(const ReleaseInput&) const = default;
};
/// Takes an instance away, or fragments of it, without any force.
struct RemoveInput {
    InstancePart part;
    bool operator==(const RemoveInput&) const = default;
};

/// Everything that acts on a session from outside.
using PlayInput = std::variant<ShotInput, ThresholdInput, MaterialInput, BreakInput, GravityInput, DestructionInput,
                               GrabInput, DragInput, ReleaseInput, RemoveInput>;

/// An input, applied after `step` steps, before the next one.
struct TimedInput {
    std::uint64_t step = 0;
    PlayInput input;
    bool operator==(const TimedInput&) const = default;
};

}  // namespace rubble
