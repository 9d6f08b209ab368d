#pragma once

#include "core/physics/state/WorldState.h"

#include <optional>

namespace rubble {

/// The mean angular velocity of a torque-free motion over h seconds that begins with angular velocity w, both in the
/// body's axes; nothing where the body rotates too far in h for one step.
///
/// With W the mean, w' = 2 W - w the final angular velocity and m = I w, the implicit midpoint rule of Euler's
/// equations, I (W - w) + h/2 W x I W = 0, conserves the energy w . I w, and since it means m' = cay(h W)^T m, the
/// rotation R' = R cay(h W) conserves the angular momentum R m: both exactly, for any inertia. In principal axes the
/// coefficients of Euler's equations are at most 1, however slender the body, so that Newton's method converges.
/// Source: Austin, Krishnaprasad, Wang 1993, "Almost Poisson integration of rigid body systems".
std::optional<Vec3f> meanAngularVelocity(const Body& body, Vec3f w, float h);

/// A rotation and the angular velocity, in the body's axes.
struct TorqueFreeMotion {
    Quatf rotation;
    Vec3f angularVelocity{0.0f, 0.0f, 0.0f};
};

/// The torque-free motion after h seconds, in as many steps as it needs. A body that would need too many rotates about
/// its angular momentum only: this conserves the same, but not the phase.
TorqueFreeMotion advanced(const Body& body, TorqueFreeMotion motion, float h);

}  // namespace rubble
