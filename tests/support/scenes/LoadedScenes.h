#pragma once

#include "core/physics/world/BodyScene.h"

#include <string>
#include <vector>

namespace rubble::test {

// Light bodies under a heavy one, which is the last of the scene. `ratio` is its mass by that of a light body. The
// ground is the first body, its top the plane y = 0; friction 0.6.

/// `count` cubes of 1 m and 100 kg, and a heavy cube on them.
BodyScene loadedTower(int count, double ratio);
/// A slab on four stones of 0.3 m, one at each corner.
BodyScene slabOnStones(double ratio);
/// A slab on `count` x `count` pebbles of 0.1 m.
BodyScene slabOnPebbles(int count, double ratio);
/// A cube on `count` plates of 2 cm.
BodyScene cubeOnPlates(int count, double ratio);
/// A slab on four props of 1 m that are 8 cm thick.
BodyScene slabOnProps(double ratio);
/// A cube on the top of a pyramid of blocks.
BodyScene loadedPyramid(double ratio);

/// A loaded scene and its name.
struct LoadedScene {
    std::string name;
    BodyScene scene;
};
/// All of them, at ratios of 100, 300, 1,000 and 3,000.
std::vector<LoadedScene> loadedScenes();

}  // namespace rubble::test
