#pragma once

#include "core/physics/world/BodyScene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble::test {

// Scenes for tests, benchmarks and demos of the simulation. Bodies stand on the plane y = 0; static bodies come first;
// density 1000 kg/m³, friction 0.6, restitution 0. Deterministic.

/// The house of 77 polytopes, its roof with friction 0.8.
BodyScene houseScene();

/// The house with every polytope cut into 8: 616 bodies, held together by friction only.
BodyScene cutHouseScene();

/// `count` fragments about to fall into a pen: prisms of 5 to 8 sides, 0.3 m wide, 0.5 m deep, of 64 shapes, with
/// random rotations on a lattice of 0.6 m, 8 layers high, which fills a square pen with walls 6 m high.
BodyScene heapScene(std::uint32_t count);

/// Ten courses of ten bricks of 1 x 0.5 x 0.5 m in running bond, half a brick at both ends of every other: 105 bodies.
BodyScene wallScene();

/// A pyramid of 1 m boxes in rows of 20, 19, ..., 1: 210 bodies.
BodyScene pyramidScene();

// Scenes in motion.

/// About so many fragments of a wall of 4 m by 0.5 m, of 12 m length in all, that fly at `speed`, m/s, from a point
/// 1.25 m behind it, from which they are 3.5 m away at most: Voronoi prisms, splinters, or boxes.
BodyScene burstScene(std::uint32_t pieces, double speed);
BodyScene splinterBurstScene(std::uint32_t pieces, double speed);
BodyScene boxBurstScene(std::uint32_t pieces, double speed);

/// A tower of 4 by 4 boxes of 0.5 m on each level that rotates about an edge of its foot.
BodyScene topplingTowerScene(std::uint32_t levels);

/// The scene of a name: "house", "cut-house", "wall", "pyramid", "heap-600", "tower-30", "burst-4700-12" (fragments,
/// m/s), "splinters-4700-12", "boxes-4700-12", ...; empty for any other.
BodyScene sceneNamed(const std::string& name);

/// The number of its dynamic bodies.
std::size_t freeBodies(const BodyScene& scene);

}  // namespace rubble::test
