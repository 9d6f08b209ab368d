#pragma once

#include "core/physics/BodyScene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble::test {

// What tests, benchmarks and demos of the simulation move. All stand on the plane y = 0, on static bodies that come first;
// density 1000 kg/m^3, friction 0.6, restitution 0. The same bits every time.

/// The house of 77 polytopes, its roof with friction 0.8.
BodyScene houseScene();

/// The house with every polytope cut in 8 where it stands: 616 bodies, which hold each other by friction alone.
BodyScene cutHouseScene();

/// `count` fragments about to fall into a pen: prisms of 5 to 8 sides, 0.3 m across, 0.5 m deep, of 64 forms, turned at
/// random on a lattice 0.6 m apart, 8 layers high; the pen is a square of walls 6 m high that the lattice fills.
BodyScene heapScene(std::uint32_t count);

/// Ten courses of ten bricks of 1 x 0.5 x 0.5 m in running bond, half a brick at both ends of every other: 105 bodies.
BodyScene wallScene();

/// Boxes of 1 m in rows of 20, 19, ... 1, each over the joint of two: 210 bodies.
BodyScene pyramidScene();

/// A scene by its name on the command line of benchmarks: "house", "cut-house", "wall", "pyramid", "heap-600", ...; empty for
/// any other.
BodyScene sceneNamed(const std::string& name);

/// How many of its bodies move.
std::size_t freeBodies(const BodyScene& scene);

}  // namespace rubble::test
