#include "viewport/render/light/Lighting.h"

#include "core/base/math/Trigonometry.h"
#include "viewport/render/light/ToneMapping.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {
namespace {

constexpr double kPartOfLamp = 0.4;  // radius of the part of it that one of many samples blurs
constexpr double kNearlyUp = 0.999;  // the height of a direction that is no axis to turn around
constexpr double kGoldenAngle = 2.39996322972865332;
constexpr double kRegionDistances = 6.0;  // least radius of the lit region, of the camera's distance
constexpr double kDarkSoil = 0.4;         // sRGB, below which lines on it are bright
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

Environment darkLines() {
    return {.grid = {0.85f, 0.88f, 0.95f, 0.16f},
            .hulls = {0.25f, 0.95f, 0.85f, 1.0f},
            .wires = {0.82f, 0.86f, 0.92f, 1.0f}};
}
Environment brightLines() {
    return {
        .grid = {0.2f, 0.24f, 0.32f, 0.17f}, .hulls = {0.0f, 0.42f, 0.5f, 1.0f}, .wires = {0.16f, 0.2f, 0.27f, 1.0f}};
}

Vec3 shownAs(double red, double green, double blue) { return radianceShownAs(linearOf(Vec3(red, green, blue))); }

/// The studio's backdrop, as it is shown.
void setBackdrop(Environment& made, bool isDark) {
    made.backgroundTop = isDark ? shownAs(0.27, 0.29, 0.33) : shownAs(0.985, 0.985, 0.99);
    made.backgroundBottom = isDark ? shownAs(0.13, 0.14, 0.16) : shownAs(0.86, 0.88, 0.91);
    made.zenith = isDark ? shownAs(0.10, 0.12, 0.16) : shownAs(0.56, 0.70, 0.87);
    made.horizon = isDark ? shownAs(0.27, 0.295, 0.335) : shownAs(0.93, 0.945, 0.955);
    made.soil = isDark ? shownAs(0.235, 0.245, 0.265) : shownAs(0.845, 0.835, 0.815);
}

}  // namespace

Environment environmentOf(SkyPreset preset, Theme theme, const SkyLight& light) {
    const bool isStudio = preset == SkyPreset::Studio && !light.background;
    const Vec3 full = light.sunOnGround + light.skyOnGround, soil = light.sky.groundAlbedo * full;
    const bool isDark = light.background ? srgbOf(toneMapped(soil)).y < kDarkSoil
                        : isStudio       ? theme == Theme::Dark
                                         : preset == SkyPreset::Night;
    Environment made = isDark ? darkLines() : brightLines();
    made.isDark = isDark;
    made.groundKey = light.sunOnGround / glm::max(full, 1e-9);  // a sky may have no light of a colour
    if (isStudio) {
        setBackdrop(made, isDark);
        return made;
    }
    made.isConcrete = true;
    made.zenith = light.sky.zenith;
    made.horizon = light.sky.horizon;
    made.glow = light.sky.glow;
    made.backgroundTop = glm::mix(light.sky.zenith, light.sky.horizon, 0.4);
    made.backgroundBottom = light.sky.horizon;
    made.soil = soil;
    return made;
}

LightSample singleSample(const Sky& sky) {
    return {
        .keyDirection = sky.sunDirection, .keyRadius = sky.sunRadius, .sky = skyDirections(kSkyDirections, 0.5, 0.0)};
}

LightSample lightSample(const Sky& sky, int index) {
    const Vec3 centre = sky.sunDirection;
    const Vec3 aside = std::abs(centre.y) < kNearlyUp ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(aside, centre)), up = glm::cross(centre, right);
    const double radius = sky.sunRadius * std::sqrt(quasirandom(index, kSteps[0]));
    const double angle = kFullTurn * quasirandom(index, kSteps[1]);
    return {.index = index,
            .keyDirection = glm::normalize(centre + radius * (cosine(angle) * right + sine(angle) * up)),
            .keyRadius = kPartOfLamp * sky.sunRadius,
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
