#pragma once

#include "core/physics/math/Vec3f.h"

#include <cstdint>

namespace rubble {

/// The data of a body that the solver reads and writes in every pass: one cache line of sixteen floats, loaded by rows.
struct alignas(64) BodyMotion {
    Vec3f velocity{0.0f, 0.0f, 0.0f};         // m/s
    float inverseMass = 0.0f;                 // 1/kg
    Vec3f angularVelocity{0.0f, 0.0f, 0.0f};  // rad/s: for the inertia at the beginning of the step
    float linearDamping = 0.0f;               // 1/s
    Vec3f deltaPosition{0.0f, 0.0f, 0.0f};    // m, since the beginning of the step
    float angularDamping = 0.0f;              // 1/s
    Quatf deltaRotation;                      // since the beginning of the step; normalized only at its end
};
static_assert(sizeof(BodyMotion) == 64);

/// The pose of a body at the beginning of the step, and the data that is read along with it.
struct alignas(64) BodyPose {
    Vec3f centre{0.0f, 0.0f, 0.0f};  // m, of mass
    float arc = 0.0f;                // m: the part of `travel` by rotation
    Quatf rotation;                  // world from body
    SymMat3f inverseInertia;         // 1/(kg·m²), in world axes
    float boundingRadius = 0.0f;     // m: distance from the centre of mass to the farthest corner
    float travel = 0.0f;  // m: an upper bound of the distance that any point has moved since the body was added
};
static_assert(sizeof(BodyPose) == 64);

/// The velocities of a body before the solver changes them: the first half of its BodyMotion.
struct alignas(32) StartMotion {
    Vec3f velocity{0.0f, 0.0f, 0.0f};  // m/s
    float inverseMass = 0.0f;
    Vec3f angularVelocity{0.0f, 0.0f, 0.0f};  // rad/s
    float linearDamping = 0.0f;
};
static_assert(sizeof(StartMotion) == 32);

/// The mechanical energy that a body lost in a step.
struct BodyLoss {
    float energy = 0.0f;     // J
    bool mayBeFree = false;  // its motion is near that of a body that touches nothing
};

}  // namespace rubble
