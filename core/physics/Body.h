#pragma once

#include "core/physics/Shape.h"

#include <compare>
#include <cstdint>

namespace rubble {

inline constexpr double kFarthest = 1e5;  // m from the origin, of a body: single precision is good to 8 mm there
inline constexpr double kFastest = 1e4;   // m/s or rad/s; at the usual 1/60 s that is 170 m a step

/// Names a body of a world for good: the index is used again after the body is removed, the pair never is.
struct BodyId {
    std::uint32_t index = 0;  // 0 names no body
    std::uint32_t generation = 0;
    auto operator<=>(const BodyId&) const = default;
};

enum class BodyKind : std::uint8_t {
    Static,     // never moves
    Kinematic,  // moves as it is told, pushed by nothing
    Dynamic,    // moved by forces and contacts
};

/// What a body is made of.
struct BodyMaterial {
    double density = 1000.0;  // kg/m^3
    double friction = 0.6;
    double restitution = 0.0;  // in [0, 1]
};

/// How a body is made.
struct BodyDefinition {
    std::shared_ptr<const Shape> shape;
    BodyKind kind = BodyKind::Dynamic;
    Pose pose;                            // of the shape's frame in the world
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s, of the centre of mass
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s, in world axes
    double density = 1000.0;              // kg/m^3
    double friction = 0.6;
    double restitution = 0.0;     // in [0, 1]
    double linearDamping = 0.0;   // 1/s
    double angularDamping = 0.0;  // 1/s
    std::uint64_t tag = 0;        // the caller's own, handed back in events

    BodyMaterial material() const { return {density, friction, restitution}; }
};

/// How a body is and moves.
struct BodyState {
    Pose pose;             // of the shape's frame
    Vec3 centre;           // m, of mass
    Vec3 velocity;         // m/s, of the centre of mass
    Vec3 angularVelocity;  // rad/s, in world axes
    bool asleep = false;
};

}  // namespace rubble
