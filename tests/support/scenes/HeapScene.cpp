#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <cmath>
#include <numbers>

namespace rubble::test {
namespace {

constexpr std::uint32_t kForms = 64;
constexpr std::uint32_t kLayers = 8;
constexpr double kSpacing = 0.6;       // m: a fragment's diagonal is 0.58
constexpr double kAcross = 0.3;        // m
constexpr double kDepth = 0.5;         // m
constexpr double kPenHeight = 6.0;     // m
constexpr double kPenThickness = 1.0;  // m
constexpr std::uint64_t kSeed = 20;

/// A ring of corners on a circle, each displaced by at most 0.3 steps from a regular polygon.
Polytope fragmentForm(Random& random) {
    const auto corners = static_cast<int>(5 + random.below(4));
    std::vector<Vec2> ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi / corners * (k + random.between(-0.3, 0.3));
        ring.push_back(0.5 * kAcross * Vec2(cosine(angle), sine(angle)));
    }
    return extruded(ring, -0.5 * kDepth, 0.5 * kDepth);
}

void addPen(BodyScene& scene, double half) {
    const double outer = half + kPenThickness;
    addGround(scene, outer);
    addFixedBox(scene, "wall -x", {-outer, 0.0, -outer}, {-half, kPenHeight, outer});
    addFixedBox(scene, "wall +x", {half, 0.0, -outer}, {outer, kPenHeight, outer});
    addFixedBox(scene, "wall -z", {-half, 0.0, -outer}, {half, kPenHeight, -half});
    addFixedBox(scene, "wall +z", {-half, 0.0, half}, {half, kPenHeight, outer});
}

}  // namespace

BodyScene heapScene(std::uint32_t count) {
    std::uint32_t across = 1;
    while (across * across * kLayers < count) ++across;
    BodyScene scene;
    addPen(scene, 0.5 * kSpacing * across);
    Random random(kSeed);
    std::vector<std::uint32_t> forms;
    for (std::uint32_t k = 0; k < kForms; ++k) forms.push_back(addShape(scene, {fragmentForm(random)}));
    for (std::uint32_t k = 0; k < count; ++k) {
        const Vec3 cell(k % across, k / (across * across), k / across % across);
        const Vec3 corner(-0.5 * (across - 1), 0.5, -0.5 * (across - 1));
        const Quat turn = randomRotation(random);  // a call's arguments would be drawn in the compiler's order
        const std::uint32_t form = forms[random.below(kForms)];
        addFreeBody(scene, "fragment " + std::to_string(k), form, {kSpacing * (cell + corner), turn});
    }
    return scene;
}

}  // namespace rubble::test
