#include "viewport/render/light/Lighting.h"

#include "core/base/math/Trigonometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {
namespace {

constexpr double kLampRadius = 0.045;  // of its distance: soft shadows whose casters remain recognizable
constexpr double kPartOfLamp = 0.4;    // radius of the part of it that one of many samples blurs
constexpr double kGoldenAngle = 2.39996322972865332;
constexpr double kRegionDistances = 6.0;  // least radius of the lit region, of the camera's distance
constexpr double kRegionStep = 0.25;      // of its radius, by which the region moves

/// Term `index` of an additive recurrence in [0, 1); `step` irrational.
double quasirandom(int index, double step) {
    const double value = 0.5 + step * static_cast<double>(index);
    return value - std::floor(value);
}

/// Steps of a four-dimensional low-discrepancy sequence: powers of the inverse of the root of x^5 = x + 1.
constexpr double kSteps[] = {0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101};

/// An order of [0, count), a power of two, of which the first few are spread evenly, and so is each second one: the
/// bits of k but the last in reverse order.
int spreadRank(int k, int count) {
    int reversed = 0;
    for (int bit = 2; bit < count; bit *= 2) reversed = 2 * reversed + ((k & bit) != 0 ? 1 : 0);
    return 2 * reversed + (k & 1);
}

/// `count` (a power of two) directions, spread evenly over the upper hemisphere, shifted in height by a fraction of a
/// step and rotated.
std::vector<Vec3> skyDirections(int count, double shift, double rotation) {
    std::vector<Vec3> directions;
    for (int k = 0; k < count; ++k) {
        const int rank = spreadRank(k, count);
        const double height = (rank + shift) / count, around = kGoldenAngle * rank + rotation;
        const double horizontal = std::sqrt(1.0 - height * height);
        directions.emplace_back(horizontal * cosine(around), height, horizontal * sine(around));
    }
    return directions;
}

}  // namespace

Environment environmentOf(Theme theme) {
    if (theme == Theme::Dark) {
        return {.backgroundTop = {0.27f, 0.29f, 0.33f, 1.0f},
                .backgroundBottom = {0.13f, 0.14f, 0.16f, 1.0f},
                .grid = {0.85f, 0.88f, 0.95f, 0.16f},
                .hulls = {0.25f, 0.95f, 0.85f, 1.0f},
                .wires = {0.82f, 0.86f, 0.92f, 1.0f},
                .zenith = {0.10f, 0.12f, 0.16f},
                .horizon = {0.27f, 0.295f, 0.335f},
                .soil = {0.235f, 0.245f, 0.265f},
                .keyLight = {0.86f, 0.81f, 0.74f},
                .skyLight = {0.30f, 0.34f, 0.41f},
                .bounceLight = {0.10f, 0.10f, 0.10f},
                .headlight = 0.07f,
                .dustLight = 0.62f};
    }
    return {.backgroundTop = {0.99f, 0.99f, 1.0f, 1.0f},
            .backgroundBottom = {0.86f, 0.88f, 0.91f, 1.0f},
            .grid = {0.2f, 0.24f, 0.32f, 0.17f},
            .hulls = {0.0f, 0.42f, 0.5f, 1.0f},
            .wires = {0.16f, 0.2f, 0.27f, 1.0f},
            .zenith = {0.56f, 0.70f, 0.87f},
            .horizon = {0.93f, 0.945f, 0.955f},
            .soil = {0.845f, 0.835f, 0.815f},
            .keyLight = {0.88f, 0.83f, 0.75f},
            .skyLight = {0.39f, 0.43f, 0.50f},
            .bounceLight = {0.21f, 0.20f, 0.18f},
            .headlight = 0.08f,
            .dustLight = 1.05f};
}

Vec3 keyDirection() { return glm::normalize(Vec3(-0.45, 0.95, 0.62)); }

LightSample singleSample() {
    return {.keyDirection = keyDirection(), .keyRadius = kLampRadius, .sky = skyDirections(kSkyDirections, 0.5, 0.0)};
}

LightSample lightSample(int index) {
    const Vec3 centre = keyDirection();
    const Vec3 right = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), centre)), up = glm::cross(centre, right);
    const double radius = kLampRadius * std::sqrt(quasirandom(index, kSteps[0]));
    const double angle = kFullTurn * quasirandom(index, kSteps[1]);
    return {.index = index,
            .keyDirection = glm::normalize(centre + radius * (cosine(angle) * right + sine(angle) * up)),
            .keyRadius = kPartOfLamp * kLampRadius,
            .sky = skyDirections(kSampledSkyDirections, quasirandom(index, kSteps[2]),
                                 kFullTurn * quasirandom(index, kSteps[3])),
            .pixelOffset = {quasirandom(index, kSteps[1]) - 0.5, quasirandom(index, kSteps[3]) - 0.5},
            .patternPhase = quasirandom(index, kSteps[0])};
}

LightRegion lightRegion(const Box3& bounds, const Camera& camera) {
    const double whole = 0.5 * bounds.diagonal() * 1.01 + 1e-6;
    const double needed = kRegionDistances * camera.distance;
    LightRegion region{bounds.centre(), whole};
    while (0.5 * region.radius >= needed) region.radius *= 0.5;
    if (region.radius == whole) return region;
    const double step = kRegionStep * region.radius;
    for (int axis = 0; axis < 3; ++axis) region.centre[axis] = step * std::round(camera.target[axis] / step);
    return region;
}

}  // namespace rubble
