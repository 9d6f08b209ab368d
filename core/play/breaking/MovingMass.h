#pragma once

#include "core/physics/world/World.h"

namespace rubble {

/// Mass and motion of a rigid body as a value, for computing impulses without applying them to the world.
struct MovingMass {
    double inverseMass = 0.0;             // 1/kg; 0: immovable
    Mat3 inertia{0.0};                    // kg·m² about its centre, in world axes
    Mat3 inverseInertia{0.0};             // 0: it cannot rotate
    Vec3 centre{0.0, 0.0, 0.0};           // m
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s

    Vec3 velocityAt(Vec3 point) const { return velocity + glm::cross(angularVelocity, point - centre); }
    /// Its part of the inverse effective mass at a point along a unit direction, 1/kg.
    double inverseEffectiveMass(Vec3 point, Vec3 direction) const;
    void applyImpulse(Vec3 impulse, Vec3 point);
    /// J; 0 where immovable.
    double kineticEnergy() const;
};

/// A solid at rest.
MovingMass restingMass(const Shape& shape, double density, const Pose& pose);
/// A body of the world; static and kinematic bodies are immovable.
MovingMass movingMass(const World& world, BodyId body);

/// The impulse that stops two bodies' approach at a point and separates them with the restitution, N·s; 0 if they
/// separate. `normal` points from the first to the second.
double stoppingImpulse(const MovingMass& first, const MovingMass& second, Vec3 point, Vec3 normal, double restitution);

/// The linear or angular velocity, shortened where it exceeds that of a body, kMaxSpeed.
Vec3 limitedVelocity(Vec3 velocity);

}  // namespace rubble
