#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/search/Box3.h"
#include "tests/support/scenes/BodyShapes.h"
#include "tests/support/scenes/RestingScenes.h"
#include "tests/support/scenes/SceneParts.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace rubble::test {
namespace {

constexpr double kStackGroundHalf = 20.0;  // m
constexpr double kMaxRotation = 0.05;      // rad
constexpr double kMaxOffset = 0.01;        // of the width
constexpr double kRightAngle = 0.5 * std::numbers::pi;

/// A kind of body in a stack.
struct Layer {
    std::uint32_t shape = 0;
    double height = 0.0;  // m
    double width = 0.0;   // m, along x or z, whichever is less
};

double widthOf(const std::vector<Polytope>& hulls) {
    Box3 bounds;
    for (const Polytope& hull : hulls) {
        for (const Vec3& vertex : hull.vertices) bounds.include(vertex);
    }
    const Vec3 size = bounds.max - bounds.min;
    return std::min(size.x, size.z);
}

/// Builds a stack from the ground up.
class FlatStack {
public:
    explicit FlatStack(std::uint64_t randomSeed) : m_random(randomSeed) { addGround(m_scene, kStackGroundHalf); }

    Layer layerOf(std::vector<Polytope> hulls, double height) {
        const double width = widthOf(hulls);
        return {addShape(m_scene, std::move(hulls)), height, width};
    }
    /// Lays a body on the top, rotated about the vertical by `angle` and a random angle.
    SceneBody& lay(Layer layer, double angle = 0.0) {
        const double most = kMaxOffset * layer.width;
        const double x = m_random.between(-most, most);
        const double z = m_random.between(-most, most);
        const double half = 0.5 * (angle + m_random.between(-kMaxRotation, kMaxRotation));
        const std::string name = "layer " + std::to_string(m_scene.bodies.size());
        addFreeBody(m_scene, name, layer.shape,
                    {{x, m_top + 0.5 * layer.height, z}, Quat(cosine(half), 0.0, sine(half), 0.0)});
        m_top += layer.height;
        return m_scene.bodies.back();
    }
    BodyScene finished() && { return std::move(m_scene); }

private:
    Random m_random;
    BodyScene m_scene;
    double m_top = 0.0;  // m
};

/// `count` bodies of the same hulls, each rotated by `angle` from the one below.
BodyScene stackOf(std::vector<Polytope> hulls, double height, int count, std::uint64_t randomSeed, double angle = 0.0) {
    FlatStack stack(randomSeed);
    const Layer layer = stack.layerOf(std::move(hulls), height);
    for (int k = 0; k < count; ++k) stack.lay(layer, angle * k);
    return std::move(stack).finished();
}

/// `count` bodies, and a plate of 1,000 times their mass on them.
BodyScene loadedStack(std::vector<Polytope> hulls, double height, double mass, int count, std::uint64_t randomSeed) {
    constexpr Vec3 kPlate(0.5, 0.1, 0.5);
    constexpr double kMassRatio = 1000.0;
    FlatStack stack(randomSeed);
    const Layer layer = stack.layerOf(std::move(hulls), height);
    const Layer plate = stack.layerOf({boxOf(kPlate)}, kPlate.y);
    for (int k = 0; k < count; ++k) stack.lay(layer);
    stack.lay(plate).density = kMassRatio * mass / (kPlate.x * kPlate.y * kPlate.z);
    return std::move(stack).finished();
}

BodyScene mixedStack(std::uint64_t randomSeed) {
    constexpr double kHeight = 0.1;
    FlatStack stack(randomSeed);
    const std::array layers{stack.layerOf(frameHulls(1.0, 0.2, kHeight), kHeight),
                            stack.layerOf({discHull(0.6, kHeight, 24)}, kHeight),
                            stack.layerOf(ringHulls(0.5, 0.35, kHeight, 12), kHeight),
                            stack.layerOf({boxOf({1.0, kHeight, 1.0})}, kHeight)};
    for (std::size_t k = 0; k < 12; ++k) stack.lay(layers[k % layers.size()]);
    return std::move(stack).finished();
}

constexpr std::array kStacks{
    RestingScene{"frames", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(frameHulls(1.0, 0.2, 0.2), 0.2, 8, s); }},
    RestingScene{"flat frames", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(frameHulls(1.0, 0.1, 0.05), 0.05, 20, s); }},
    RestingScene{"rings", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(ringHulls(0.5, 0.35, 0.1, 12), 0.1, 8, s); }},
    RestingScene{"gears", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(gearHulls(0.5, 0.1, 0.1, 12), 0.1, 10, s); }},
    RestingScene{"e shapes", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(eHulls(1.0, 0.15), 0.15, 8, s); }},
    RestingScene{"u shapes", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(uHulls(1.0, 0.15), 0.15, 8, s); }},
    RestingScene{"l shapes",
                 RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(lHulls(1.0, 0.15), 0.15, 8, s); },
                 {.drift = 0.012}},  // the middle of an L lies near its edge
    RestingScene{"crosses", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf(crossHulls(1.0, 0.1), 0.1, 10, s); }},
    RestingScene{"discs", RestingKind::Stack,
                 [](std::uint64_t s) { return stackOf({discHull(0.3, 0.1, 24)}, 0.1, 12, s); }},
    RestingScene{"plates", RestingKind::Stack,
                 [](std::uint64_t s) {
                     return stackOf({boxOf({1.0, 0.02, 1.0})}, 0.02, 24, s);
                 }},
    RestingScene{"thin plates", RestingKind::Stack,
                 [](std::uint64_t s) {
                     return stackOf({boxOf({1.0, 0.01, 1.0})}, 0.01, 12, s);
                 }},
    RestingScene{"bricks", RestingKind::Stack,
                 [](std::uint64_t s) {
                     return stackOf({boxOf({0.25, 0.065, 0.12})}, 0.065, 12, s, kRightAngle);
                 }},
    RestingScene{"cubes",
                 RestingKind::Stack,
                 [](std::uint64_t s) {
                     return stackOf({boxOf({1.0, 1.0, 1.0})}, 1.0, 10, s);
                 },
                 {.drift = 0.015}},  // a tower of ten metres leans by its offsets of a centimetre
    RestingScene{"loaded cubes", RestingKind::Stack,
                 [](std::uint64_t s) { return loadedStack({boxOf(Vec3(0.25))}, 0.25, 15.625, 3, s); }},
    RestingScene{"loaded frames", RestingKind::Stack,
                 [](std::uint64_t s) { return loadedStack(frameHulls(0.5, 0.1, 0.1), 0.1, 16.0, 4, s); }},
    RestingScene{"mixed", RestingKind::Stack, mixedStack},
};

}  // namespace

std::span<const RestingScene> stackScenes() { return kStacks; }

}  // namespace rubble::test
