#pragma once

#include "core/asset/Project.h"

#include <variant>

namespace rubble {

/// Something is done to the scene: thrown, struck or blown up.
struct ShotInput {
    std::string name;
    ShotAction action;
    bool operator==(const ShotInput&) const = default;
};
/// From now on an asset, or one instance, breaks at another threshold.
struct ThresholdInput {
    Id asset = 0;
    Id instance = 0;         // instead of the asset where it is not 0
    double threshold = 0.0;  // N s, > 0
    bool operator==(const ThresholdInput&) const = default;
};
/// From now on the material of this id has these values.
struct MaterialInput {
    Material material;
    bool operator==(const MaterialInput&) const = default;
};
/// A body breaks now, by no force: as one looks at what its pieces do by themselves.
struct BreakInput {
    std::uint32_t body = 0;  // its number
    bool operator==(const BreakInput&) const = default;
};
struct GravityInput {
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s^2
    bool operator==(const GravityInput&) const = default;
};
/// Whether things break at all.
struct DestructionInput {
    bool isOn = true;
    bool operator==(const DestructionInput&) const = default;
};
/// Takes hold of a point of a body, draws that point about, lets go.
struct GrabInput {
    std::uint32_t body = 0;     // its number
    Vec3 point{0.0, 0.0, 0.0};  // of the world, m
    double force = 0.0;         // N at most
    bool operator==(const GrabInput&) const = default;
};
struct DragInput {
    Vec3 to{0.0, 0.0, 0.0};  // m
    bool operator==(const DragInput&) const = default;
};
struct LetGoInput {
    bool operator==(const LetGoInput&) const = default;
};

/// All that comes to a session from outside.
using PlayInput = std::variant<ShotInput, ThresholdInput, MaterialInput, BreakInput, GravityInput, DestructionInput,
                               GrabInput, DragInput, LetGoInput>;

/// An input and when: after so many steps, before the next.
struct TimedInput {
    std::uint64_t step = 0;
    PlayInput input;
    bool operator==(const TimedInput&) const = default;
};

}  // namespace rubble
