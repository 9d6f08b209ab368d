#include "tests/support/scenes/LoadedScenes.h"

#include "tests/support/scenes/SceneParts.h"

namespace rubble::test {
namespace {

constexpr double kDensity = 100.0;  // kg/m³, of light bodies

/// A scene that is built by boxes.
class LoadedBuilder {
public:
    LoadedBuilder() { addGround(m_scene, 20.0); }

    void addBox(Vec3 size, Vec3 position) {
        const std::uint32_t shape = addShape(m_scene, {boxOf(size)});
        addFreeBody(m_scene, std::to_string(m_scene.bodies.size()), shape, {.position = position});
        m_scene.bodies.back().density = kDensity;
    }
    /// Adds a box of a mass.
    BodyScene loaded(Vec3 size, Vec3 position, double mass) && {
        addBox(size, position);
        m_scene.bodies.back().density = mass / (size.x * size.y * size.z);
        return std::move(m_scene);
    }

private:
    BodyScene m_scene;
};

double massOf(Vec3 size) { return kDensity * size.x * size.y * size.z; }

}  // namespace

BodyScene loadedTower(int count, double ratio) {
    constexpr Vec3 kCube(1.0);
    LoadedBuilder builder;
    for (int k = 0; k < count; ++k) builder.addBox(kCube, {0.0, k + 0.5, 0.0});
    return std::move(builder).loaded(kCube, {0.0, count + 0.5, 0.0}, ratio * massOf(kCube));
}

BodyScene slabOnStones(double ratio) {
    constexpr Vec3 kStone(0.3), kSlab(2.0, 0.2, 2.0);
    LoadedBuilder builder;
    for (const double x : {-0.8, 0.8}) {
        for (const double z : {-0.8, 0.8}) builder.addBox(kStone, {x, 0.15, z});
    }
    return std::move(builder).loaded(kSlab, {0.0, 0.4, 0.0}, ratio * massOf(kStone));
}

BodyScene slabOnPebbles(int count, double ratio) {
    constexpr Vec3 kPebble(0.1);
    const double width = 0.15 * count;
    LoadedBuilder builder;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            builder.addBox(kPebble, {0.15 * (i + 0.5) - 0.5 * width, 0.05, 0.15 * (k + 0.5) - 0.5 * width});
        }
    }
    return std::move(builder).loaded({width, 0.2, width}, {0.0, 0.2, 0.0}, ratio * count * count * massOf(kPebble));
}

BodyScene cubeOnPlates(int count, double ratio) {
    constexpr Vec3 kPlate(0.6, 0.02, 0.6);
    LoadedBuilder builder;
    for (int k = 0; k < count; ++k) builder.addBox(kPlate, {0.0, kPlate.y * (k + 0.5), 0.0});
    return std::move(builder).loaded(Vec3(0.5), {0.0, kPlate.y * count + 0.25, 0.0}, ratio * massOf(kPlate));
}

BodyScene slabOnProps(double ratio) {
    constexpr Vec3 kProp(0.08, 1.0, 0.08);
    LoadedBuilder builder;
    for (const double x : {-0.8, 0.8}) {
        for (const double z : {-0.5, 0.5}) builder.addBox(kProp, {x, 0.5, z});
    }
    return std::move(builder).loaded({2.0, 0.2, 1.4}, {0.0, 1.1, 0.0}, ratio * massOf(kProp));
}

BodyScene loadedPyramid(double ratio) {
    constexpr int kBase = 5;
    constexpr Vec3 kBlock(1.0, 0.5, 0.5);
    LoadedBuilder builder;
    for (int row = 0; row < kBase; ++row) {
        for (int k = 0; k < kBase - row; ++k) {
            builder.addBox(kBlock, {k - 0.5 * (kBase - row - 1), 0.5 * row + 0.25, 0.0});
        }
    }
    return std::move(builder).loaded(Vec3(1.0), {0.0, 0.5 * kBase + 0.5, 0.0}, ratio * massOf(kBlock));
}

std::vector<LoadedScene> loadedScenes() {
    std::vector<LoadedScene> scenes;
    for (const int ratio : {100, 300, 1000, 3000}) {
        const std::string under = " under " + std::to_string(ratio);
        for (int count = 1; count <= 5; ++count) {
            scenes.push_back({"tower of " + std::to_string(count) + under, loadedTower(count, ratio)});
        }
        for (const int count : {1, 3, 6}) {
            scenes.push_back({"plates: " + std::to_string(count) + under, cubeOnPlates(count, ratio)});
        }
        scenes.push_back({"stones" + under, slabOnStones(ratio)});
        scenes.push_back({"pebbles" + under, slabOnPebbles(8, ratio)});
        scenes.push_back({"props" + under, slabOnProps(ratio)});
        scenes.push_back({"pyramid" + under, loadedPyramid(ratio)});
    }
    return scenes;
}

}  // namespace rubble::test
