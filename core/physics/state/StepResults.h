#pragma once

#include "core/physics/state/BodyDefinition.h"

#include <vector>

namespace rubble {

/// Two bodies that will touch within the coming step and approach faster than 0.5 m/s; computed before the step is
/// solved.
struct Impact {
    BodyId first;
    BodyId second;
    Vec3 point;                  // the centroid of the manifold's approaching points
    Vec3 normal;                 // from first to second, length 1
    double approachSpeed = 0.0;  // m/s along the normal there, at the time of impact
    double effectiveMass = 0.0;  // kg: of both bodies at the point, including rotation
    double restitution = 0.0;    // of the pair
    /// The impulse that stops the approach and causes restitution, N·s.
    double impulse() const { return (1.0 + restitution) * approachSpeed * effectiveMass; }
};

/// Two bodies that began or ended touching.
struct ContactEvent {
    BodyId first;
    BodyId second;
};

/// Two bodies that collided faster than 0.25 m/s in the last solved step.
struct HitEvent {
    BodyId first;
    BodyId second;
    Vec3 point;
    Vec3 normal;                 // from first to second
    double approachSpeed = 0.0;  // m/s
    double impulse = 0.0;        // N·s, over the step
    /// J: mechanical energy that the contact took in the step, with friction. That of all hits is at most
    /// StepEvents::contactLoss, since what one contact takes may accelerate other bodies.
    double energy = 0.0;
};

/// The events of the last step, in a deterministic order.
struct StepEvents {
    std::vector<ContactEvent> began;
    std::vector<ContactEvent> ended;  // including those of removed bodies
    std::vector<HitEvent> hits;
    std::vector<BodyId> fellAsleep;  // by body
    /// J: mechanical energy that all contacts took in the step, hits included. World::grab() and free flight changed
    /// the rest of it.
    double contactLoss = 0.0;
};

/// A contact point.
struct ContactPoint {
    BodyId first;
    BodyId second;
    Vec3 point;
    Vec3 normal;              // from first to second
    double separation = 0.0;  // m, negative where they overlap
    double impulse = 0.0;     // N·s, of the last sub-step
    double force = 0.0;       // N: of that impulse; 0 before the first step
};

/// Statistics of the last step.
struct StepCounts {
    int bodies = 0;
    int awake = 0;           // dynamic and kinematic
    int candidatePairs = 0;  // pairs of hulls with overlapping fat boxes
    int contacts = 0;        // those with a manifold
    int contactPoints = 0;
    int separatingAxisTests = 0;  // pairs of hulls collided
    int colours = 0;
    int islands = 0;
};

/// Wall-clock milliseconds of the stages of the last step. The only output that is not deterministic.
struct StepTimes {
    double pairs = 0.0;    // broad phase
    double collide = 0.0;  // narrow phase
    double prepare = 0.0;
    double solve = 0.0;
    double finish = 0.0;  // poses, boxes, events, sleep
    double total() const { return pairs + collide + prepare + solve + finish; }
};

/// Momentum and energy, summed over the dynamic bodies.
struct Momenta {
    Vec3 linear{0.0, 0.0, 0.0};   // kg·m/s
    Vec3 angular{0.0, 0.0, 0.0};  // kg·m²/s about the world's origin
    double kinetic = 0.0;         // J
    double potential = 0.0;       // J, zero at the origin
};

}  // namespace rubble
