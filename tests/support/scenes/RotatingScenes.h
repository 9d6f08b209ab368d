#pragma once

#include "core/physics/world/BodyScene.h"

#include <cstdint>

namespace rubble::test {

// Bodies with large angular velocities: `radiansPerStep` is the angle of rotation in a step of `dt` seconds.

/// A rod of 3 m along y without gravity, its sides 1 / `aspect` of its length, rotating about `axis`, of length 1.
BodyScene freeRod(double aspect, Vec3 axis, double radiansPerStep, double dt);

/// A random convex body without gravity, its extents up to 1 : 30, with a random rotation by 0.05 to 2 rad per step.
BodyScene freeSolid(std::uint64_t randomSeed, double dt);

/// A rod of up to 1 : 100 or a plate of up to 1 : 60 that falls on a ground of 1 km, rotating by 0.1 to 1 rad per step.
BodyScene rotatingOntoGround(std::uint64_t randomSeed, double dt);

}  // namespace rubble::test
