#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <algorithm>

namespace rubble::test {
namespace {

std::string nameOf(int course, int place) { return std::to_string(course) + '.' + std::to_string(place); }

}  // namespace

BodyScene wallScene() {
    constexpr int kCourses = 10;
    constexpr int kBricks = 10;
    BodyScene scene;
    addGround(scene, 20.0);
    const std::uint32_t brick = addShape(scene, {boxOf({1.0, 0.5, 0.5})});
    const std::uint32_t halfBrick = addShape(scene, {boxOf({0.5, 0.5, 0.5})});
    for (int course = 0; course < kCourses; ++course) {
        const bool isShifted = course % 2 == 1;
        double left = -0.5 * kBricks;
        for (int place = 0; place < kBricks + (isShifted ? 1 : 0); ++place) {
            const bool isHalf = isShifted && (place == 0 || place == kBricks);
            const double length = isHalf ? 0.5 : 1.0;
            addFreeBody(scene, "brick " + nameOf(course, place), isHalf ? halfBrick : brick,
                        {.position = {left + 0.5 * length, 0.25 + 0.5 * course, 0.0}});
            left += length;
        }
    }
    return scene;
}

BodyScene pyramidScene() {
    constexpr int kBase = 20;
    BodyScene scene;
    addGround(scene, 20.0);
    const std::uint32_t box = addShape(scene, {boxOf({1.0, 1.0, 1.0})});
    for (int row = 0; row < kBase; ++row) {
        for (int place = 0; place < kBase - row; ++place) {
            addFreeBody(scene, "box " + nameOf(row, place), box,
                        {.position = {place - 0.5 * (kBase - row - 1), row + 0.5, 0.0}});
        }
    }
    return scene;
}

BodyScene sceneNamed(const std::string& name) {
    if (name == "house") return houseScene();
    if (name == "cut-house") return cutHouseScene();
    if (name == "wall") return wallScene();
    if (name == "pyramid") return pyramidScene();
    if (name.starts_with("heap-")) return heapScene(static_cast<std::uint32_t>(std::stoul(name.substr(5))));
    return {};
}

std::size_t freeBodies(const BodyScene& scene) {
    return static_cast<std::size_t>(std::ranges::count(scene.bodies, BodyKind::Dynamic, &SceneBody::kind));
}

}  // namespace rubble::test
