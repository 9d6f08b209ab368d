#pragma once

#include "core/physics/shape/Shape.h"

#include <compare>
#include <cstdint>

namespace rubble {

inline constexpr double kMaxCoordinate = 1e5;  // m: largest coordinate of a body; single precision resolves 8 mm there
inline constexpr double kMaxSpeed = 1e4;       // m/s or rad/s; 170 m per step of 1/60 s
inline constexpr double kMaxImpulse = 1e24;    // N·s, and N of a grab: of the heaviest body at kMaxSpeed, and more

/// Identifies a body of a world. Indices are reused after removal, pairs of index and generation are not.
struct BodyId {
    std::uint32_t index = 0;  // 0: no body
    std::uint32_t generation = 0;
    auto operator<=>(const BodyId&) const = default;
};

enum class BodyKind : std::uint8_t {
    Static,     // never moves
    Kinematic,  // moves by its velocity, unaffected by forces and contacts
    Dynamic,    // moved by forces and contacts
};

/// The material of a body.
struct BodyMaterial {
    double density = 1000.0;  // kg/m³
    double friction = 0.6;
    double restitution = 0.0;  // in [0, 1]
};

/// The definition of a body to add.
struct BodyDefinition {
    std::shared_ptr<const Shape> shape;
    BodyKind kind = BodyKind::Dynamic;
    Pose pose;                            // world from the shape's frame
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s, of the centre of mass
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s, in world axes
    double density = 1000.0;              // kg/m³
    double friction = 0.6;
    double restitution = 0.0;     // in [0, 1]
    double linearDamping = 0.0;   // 1/s
    double angularDamping = 0.0;  // 1/s
    bool isBullet = false;        // it is swept against everything, however fast that moves: a projectile
    std::uint64_t tag = 0;        // for the caller's use

    BodyMaterial material() const { return {density, friction, restitution}; }
};

/// The state of motion of a body.
struct BodyState {
    Pose pose;             // world from the shape's frame
    Vec3 centre;           // m, of mass
    Vec3 velocity;         // m/s, of the centre of mass
    Vec3 angularVelocity;  // rad/s, in world axes
    bool asleep = false;
};

}  // namespace rubble
