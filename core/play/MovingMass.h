#pragma once

#include "core/physics/World.h"

namespace rubble {

/// A rigid body's mass in motion, as a value: what an impulse does to it can be asked without doing it.
struct MovingMass {
    double inverseMass = 0.0;      // 1/kg; 0: nothing moves it
    Mat3 inertia{0.0};             // kg m^2 about its centre, in world axes
    Mat3 inverseInertia{0.0};      // 0 where nothing turns it
    Vec3 centre{0.0, 0.0, 0.0};    // m
    Vec3 velocity{0.0, 0.0, 0.0};  // m/s
    Vec3 spin{0.0, 0.0, 0.0};      // rad/s

    Vec3 velocityAt(Vec3 point) const { return velocity + glm::cross(spin, point - centre); }
    /// What it adds to the inverse of an effective mass at a point along a direction of length 1, 1/kg.
    double mobility(Vec3 point, Vec3 direction) const;
    void push(Vec3 impulse, Vec3 point);
};

/// A solid of a density somewhere, at rest.
MovingMass restingMass(const Shape& shape, double density, const Pose& pose);
/// A body of the world as it moves; static and kinematic bodies are moved by nothing.
MovingMass movingMass(const World& world, BodyId body);

/// The impulse in N s that stops two bodies' approach at a point, and throws them back by the restitution; 0 where they
/// part. `normal` points from the first to the second.
double stoppingImpulse(const MovingMass& first, const MovingMass& second, Vec3 point, Vec3 normal, double restitution);

}  // namespace rubble
