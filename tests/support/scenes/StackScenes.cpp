#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <algorithm>
#include <cstdlib>

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

namespace {

/// The numbers after the hyphens of a name.
std::vector<double> numbersIn(const std::string& name) {
    std::vector<double> numbers;
    for (std::size_t at = name.find('-'); at != std::string::npos; at = name.find('-', at + 1)) {
        const char* begin = name.c_str() + at + 1;
        char* end = nullptr;
        const double number = std::strtod(begin, &end);
        if (end != begin) numbers.push_back(number);
    }
    return numbers;
}

}  // namespace

BodyScene sceneNamed(const std::string& name) {
    if (name == "house") return houseScene();
    if (name == "cut-house") return cutHouseScene();
    if (name == "wall") return wallScene();
    if (name == "pyramid") return pyramidScene();
    const std::vector<double> numbers = numbersIn(name);
    if (numbers.empty()) return {};
    const auto count = static_cast<std::uint32_t>(numbers.front());
    if (name.starts_with("heap-")) return heapScene(count);
    if (name.starts_with("tower-")) return topplingTowerScene(count);
    if (numbers.size() < 2) return {};
    if (name.starts_with("burst-")) return burstScene(count, numbers[1]);
    if (name.starts_with("splinters-")) return splinterBurstScene(count, numbers[1]);
    if (name.starts_with("boxes-")) return boxBurstScene(count, numbers[1]);
    return {};
}

std::size_t freeBodies(const BodyScene& scene) {
    return static_cast<std::size_t>(std::ranges::count(scene.bodies, BodyKind::Dynamic, &SceneBody::kind));
}

}  // namespace rubble::test
