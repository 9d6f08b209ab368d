#pragma once

#include "core/physics/world/BodyScene.h"

#include <string>
#include <vector>

namespace rubble::test {

/// A body that slides to rest over a plane of flush tiles, which is the plane y = 0. The body is the last of the scene.
struct SlidingScene {
    std::string name;
    BodyScene scene;
    Vec3 direction{1.0, 0.0, 0.0};  // of the velocity, length 1
    double distance = 0.0;          // m: v² / (2 mu g)
};

/// Boxes and frames on rows and grids of tiles of several sizes, straight and diagonally, slow and fast; tiles that are
/// bodies, and tiles that are hulls of one body.
std::vector<SlidingScene> slidingScenes();

/// Boxes of ten footprints, square and oblong, and of three heights, that slide in sixteen directions over one flat
/// ground.
std::vector<SlidingScene> obliqueSlidingScenes();

}  // namespace rubble::test
