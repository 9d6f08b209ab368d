#include "core/asset/bake/Bake.h"
#include "core/base/Assert.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <cmath>

namespace rubble::test {
namespace {

constexpr Vec3 kWall{12.0, 4.0, 0.5};          // m
constexpr Vec3 kBurstCentre{0.0, 1.0, -1.25};  // m, behind the wall, whose middle is above the origin
constexpr double kBurstRadius = 3.5;           // m
constexpr double kBurstArea = 23.8;            // m²: of the wall within it
constexpr double kGroundHalfWidth = 100.0;     // m
constexpr double kSplinterRatio = 8.0;
constexpr double kToppling = 0.35;  // rad/s

Bake bakedWall(std::uint32_t pieces, std::vector<PatternLayer> layers) {
    Asset asset{.id = 1, .name = "wall", .material = 1};
    asset.shape = Prism{{{{0.0, 0.0}, {kWall.x, 0.0}, {kWall.x, kWall.y}, {0.0, kWall.y}}, {}}, kWall.z};
    const double wanted = kWall.x * kWall.y / kBurstArea * pieces;
    asset.pattern.layers = {{.id = 1, .parameters = UniformScatter{.count = static_cast<std::uint32_t>(wanted)}}};
    for (PatternLayer& layer : layers) asset.pattern.layers.push_back(std::move(layer));
    Result<Bake> bake = rubble::bake(asset);
    RUBBLE_ASSERT(bake.hasValue());
    return std::move(*bake);
}

/// Adds a body that flies from the centre of the burst, if it begins near enough.
void addThrown(BodyScene& scene, std::vector<Polytope> hulls, Vec3 place, double speed) {
    const Vec3 way = place - kBurstCentre;
    if (glm::length(way) > kBurstRadius) return;
    addFreeBody(scene, "fragment " + std::to_string(scene.bodies.size()), addShape(scene, std::move(hulls)),
                {.position = place});
    scene.bodies.back().velocity = speed * glm::normalize(way);
}

BodyScene burstOf(const Bake& bake, double speed) {
    BodyScene scene;
    addGround(scene, kGroundHalfWidth);
    const Vec3 corner(-0.5 * kWall.x, 0.0, -0.5 * kWall.z);
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment fragment = bake.fragment(k);
        addThrown(scene, fragment.solid.hulls(), corner + fragment.solid.offset(), speed);
    }
    return scene;
}

}  // namespace

BodyScene burstScene(std::uint32_t pieces, double speed) { return burstOf(bakedWall(pieces, {}), speed); }

BodyScene splinterBurstScene(std::uint32_t pieces, double speed) {
    return burstOf(bakedWall(pieces, {{.id = 2, .parameters = Grain{.angle = 0.9, .ratio = kSplinterRatio}}}), speed);
}

BodyScene boxBurstScene(std::uint32_t pieces, double speed) {
    BodyScene scene;
    addGround(scene, kGroundHalfWidth);
    const double side = std::sqrt(kBurstArea / pieces);
    const auto across = static_cast<int>(kWall.x / side), up = static_cast<int>(kWall.y / side);
    for (int row = 0; row < up; ++row) {
        for (int column = 0; column < across; ++column)
            addThrown(scene, {boxOf({side, side, kWall.z})},
                      {side * (column + 0.5 - 0.5 * across), side * (row + 0.5), 0.0}, speed);
    }
    return scene;
}

BodyScene topplingTowerScene(std::uint32_t levels) {
    constexpr int kAcross = 4;
    constexpr double kSide = 0.5;  // m
    BodyScene scene;
    addGround(scene, kGroundHalfWidth);
    const std::uint32_t box = addShape(scene, {boxOf({kSide, kSide, kSide})});
    for (std::uint32_t level = 0; level < levels; ++level) {
        for (int k = 0; k < kAcross * kAcross; ++k) {
            const Vec3 place(kSide * (k % kAcross + 0.5 - kAcross), kSide * (level + 0.5),
                             kSide * (k / kAcross + 0.5 - 0.5 * kAcross));  // its edge is the z axis
            addFreeBody(scene, "box " + std::to_string(scene.bodies.size()), box, {.position = place});
            scene.bodies.back().angularVelocity = {0.0, 0.0, -kToppling};
            scene.bodies.back().velocity = glm::cross(scene.bodies.back().angularVelocity, place);
        }
    }
    return scene;
}

}  // namespace rubble::test
