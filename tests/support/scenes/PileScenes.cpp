#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/search/Box3.h"
#include "core/physics/shape/Shape.h"
#include "tests/support/scenes/BodyShapes.h"
#include "tests/support/scenes/RestingScenes.h"
#include "tests/support/scenes/SceneParts.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace rubble::test {
namespace {

constexpr double kPileGroundHalf = 20.0;  // m
constexpr double kGap = 0.02;             // m, between the boxes of bodies at the start
constexpr double kAnyTilt = -1.0;         // any orientation

/// How the bodies of a pile lie at the start.
struct PileLayout {
    int count = 0;
    double spread = 0.0;  // m: positions are within this of the axis, along x and z
    double tilt = 0.0;    // rad: rotations from the horizontal are at most this, or kAnyTilt
};

/// A rotation about the vertical by any angle, then about a horizontal axis by at most `tilt`.
Quat tiltedRotation(Random& random, double tilt) {
    const double yaw = std::numbers::pi * random.unit();  // half of the angle
    const double direction = 2.0 * std::numbers::pi * random.unit();
    const double half = 0.5 * tilt * random.unit();
    return Quat(cosine(half), sine(half) * cosine(direction), 0.0, sine(half) * sine(direction)) *
           Quat(cosine(yaw), 0.0, sine(yaw), 0.0);
}

Box3 boundsOf(const std::vector<Polytope>& hulls, Quat orientation) {
    Box3 bounds;
    for (const Polytope& hull : hulls) {
        for (const Vec3& vertex : hull.vertices) bounds.include(orientation * vertex);
    }
    return bounds;
}

bool overlapFromAbove(const Box3& a, const Box3& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.z < b.max.z && b.min.z < a.max.z;
}

/// Bodies one after the other at random places, each as low as its bounding box may be above those before it. Shapes
/// take turns.
BodyScene pileOf(std::vector<std::vector<Polytope>> shapes, const PileLayout& layout, std::uint64_t randomSeed) {
    BodyScene scene;
    addGround(scene, kPileGroundHalf);
    const auto first = static_cast<std::uint32_t>(scene.shapes.size());
    const std::size_t kinds = shapes.size();
    for (std::vector<Polytope>& hulls : shapes) addShape(scene, std::move(hulls));
    Random random(randomSeed);
    std::vector<Box3> placed;
    for (int k = 0; k < layout.count; ++k) {
        const auto shape = first + static_cast<std::uint32_t>(static_cast<std::size_t>(k) % kinds);
        const Quat rotation = layout.tilt < 0.0 ? randomRotation(random) : tiltedRotation(random, layout.tilt);
        const double x = random.between(-layout.spread, layout.spread);
        const double z = random.between(-layout.spread, layout.spread);
        Box3 bounds = boundsOf(scene.shapes[shape], rotation);
        const auto moveBy = [&](Vec3 offset) { bounds = {bounds.min + offset, bounds.max + offset}; };
        Vec3 position(x, 0.0, z);
        moveBy(position);
        double below = 0.0;
        for (const Box3& other : placed) {
            if (overlapFromAbove(bounds, other)) below = std::max(below, other.max.y);
        }
        position.y = below + kGap - bounds.min.y;
        moveBy({0.0, position.y, 0.0});
        placed.push_back(bounds);
        addFreeBody(scene, "body " + std::to_string(k), shape, {position, rotation});
    }
    return scene;
}

BodyScene pileOfOne(Polytope hull, const PileLayout& layout, std::uint64_t randomSeed) {
    return pileOf({{std::move(hull)}}, layout, randomSeed);
}

BodyScene pileOfLetters(std::uint64_t randomSeed) {
    return pileOf({eHulls(0.5, 0.1), uHulls(0.5, 0.1), lHulls(0.5, 0.1), crossHulls(0.5, 0.1)}, {20, 0.7, 0.5},
                  randomSeed);
}

constexpr std::array kPiles{
    RestingScene{"pile of planks", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.02, 0.1}), {25, 0.5, 0.2}, s);
                 }},
    RestingScene{"poured planks", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.02, 0.1}), {25, 0.8, kAnyTilt}, s);
                 }},
    RestingScene{"high pile of planks",
                 RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.02, 0.1}), {50, 0.5, 0.1}, s);
                 },
                 {.penetration = 0.008}},  // fifty planks on the lowest
    RestingScene{"pile of needles",
                 RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(needleHull(0.8, 0.02), {30, 0.4, 0.3}, s);
                 },
                 {.seconds = 20.0}},  // on one edge they rock for long
    RestingScene{"pile of laths", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.01, 0.04}), {30, 0.5, 0.2}, s);
                 }},
    RestingScene{"pile of tetrahedra", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(tetrahedronHull(0.3), {40, 0.9, kAnyTilt}, s);
                 }},
    RestingScene{"pile of tiles", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({0.3, 0.02, 0.3}), {30, 0.45, 0.5}, s);
                 }},
    RestingScene{"pile of bricks", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({0.25, 0.065, 0.12}), {40, 0.45, kAnyTilt}, s);
                 }},
    RestingScene{"pile of rods 1:20", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.05, 0.05}), {20, 0.5, 0.2}, s);
                 }},
    RestingScene{"pile of rods 1:50", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({1.0, 0.02, 0.02}), {30, 0.5, 0.2}, s);
                 }},
    RestingScene{"pile of rods 1:100", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOfOne(boxOf({2.0, 0.02, 0.02}), {25, 0.8, 0.1}, s);
                 }},
    RestingScene{"pile of frames", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOf({frameHulls(0.6, 0.08, 0.08)}, {12, 0.3, 0.4}, s);
                 }},
    RestingScene{"pile of gears", RestingKind::Pile,
                 [](std::uint64_t s) {
                     return pileOf({gearHulls(0.25, 0.05, 0.08, 10)}, {15, 0.25, 0.4}, s);
                 }},
    RestingScene{"pile of letters", RestingKind::Pile, pileOfLetters},
};

}  // namespace

std::span<const RestingScene> pileScenes() { return kPiles; }

double thinnestSide(const BodyScene& scene) {
    double thinnest = kMaxCoordinate;
    for (const SceneBody& body : scene.bodies) {
        if (body.kind != BodyKind::Dynamic) continue;
        thinnest = std::min(thinnest, static_cast<double>((*makeShape(scene.shapes[body.shape]))->minWidth));
    }
    return thinnest;
}

}  // namespace rubble::test
