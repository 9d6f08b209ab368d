#pragma once

#include "core/physics/Vec3f.h"

#include <cstdint>

namespace rubble {

/// What the solver reads and writes of a body in every pass: one cache line. Sixteen numbers, so that lanes load it by rows.
struct alignas(64) BodyMotion {
    Vec3f velocity{0.0f, 0.0f, 0.0f};  // m/s
    float inverseMass = 0.0f;          // 1/kg
    Vec3f spin{0.0f, 0.0f, 0.0f};   // rad/s: the angular momentum through the inertia that it had when the step began
    float linearDamping = 0.0f;     // 1/s
    Vec3f moved{0.0f, 0.0f, 0.0f};  // m, since the step began
    float angularDamping = 0.0f;    // 1/s
    Quatf turned;                   // since the step began; of length 1 only where the step ends
};
static_assert(sizeof(BodyMotion) == 64);

/// What is read once a step: where a body was when the step began.
struct alignas(64) BodyPlace {
    Vec3f centre{0.0f, 0.0f, 0.0f};  // m
    float unused = 0.0f;
    Quatf turn;               // world from body
    SymMat3f inverseInertia;  // 1/(kg m^2), in world axes
    float reach = 0.0f;       // m: from the centre of mass to its farthest corner
    float travel = 0.0f;      // m: how far any point of it can have moved since it was put in
};
static_assert(sizeof(BodyPlace) == 64);

}  // namespace rubble
