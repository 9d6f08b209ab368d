#pragma once

#include "core/physics/Body.h"

#include <vector>

namespace rubble {

/// Two bodies that will touch within the step and approach faster than 0.5 m/s, before the step is solved.
struct Impact {
    BodyId first;
    BodyId second;
    Vec3 point;                  // the centroid of the manifold's approaching points
    Vec3 normal;                 // from first to second, length 1
    double approachSpeed = 0.0;  // m/s along the normal there, when they meet
    double effectiveMass = 0.0;  // kg: of both bodies there, rotation included
    double restitution = 0.0;    // of the pair
    /// N s: what stops the approach and throws it back.
    double impulse() const { return (1.0 + restitution) * approachSpeed * effectiveMass; }
};

/// Two bodies that began or ended to touch.
struct ContactEvent {
    BodyId first;
    BodyId second;
};

/// Two bodies that hit each other faster than 1 m/s in the step just solved.
struct HitEvent {
    BodyId first;
    BodyId second;
    Vec3 point;
    Vec3 normal;                 // from first to second
    double approachSpeed = 0.0;  // m/s
    double impulse = 0.0;        // N s, over the step
};

/// What happened in the last step, in a fixed order.
struct StepEvents {
    std::vector<ContactEvent> began;
    std::vector<ContactEvent> ended;  // of bodies taken out, too
    std::vector<HitEvent> hits;
};

/// A point of contact, for drawing.
struct ContactPoint {
    BodyId first;
    BodyId second;
    Vec3 point;
    Vec3 normal;              // from first to second
    double separation = 0.0;  // m, negative where they overlap
    double impulse = 0.0;     // N s, of the last sub-step
};

struct StepCounts {
    int bodies = 0;
    int awake = 0;           // dynamic and kinematic bodies that were moved
    int candidatePairs = 0;  // pairs whose boxes come near
    int contacts = 0;        // of them, pairs with a manifold
    int contactPoints = 0;
    int separatingAxisTests = 0;  // pairs that were looked at anew
    int colours = 0;
    int islands = 0;
};

/// Wall-clock milliseconds of the last step's stages. The only thing here that differs from run to run.
struct StepTimes {
    double pairs = 0.0;    // broad phase
    double collide = 0.0;  // narrow phase
    double prepare = 0.0;
    double solve = 0.0;
    double finish = 0.0;  // poses, boxes, events, sleep
    double total() const { return pairs + collide + prepare + solve + finish; }
};

/// Sums over the dynamic bodies.
struct Momenta {
    Vec3 linear{0.0, 0.0, 0.0};   // kg m/s
    Vec3 angular{0.0, 0.0, 0.0};  // kg m^2/s about the world's origin
    double kinetic = 0.0;         // J
    double potential = 0.0;       // J, against gravity from the origin
};

}  // namespace rubble
