#include "viewport/render/Lighting.h"

#include "core/base/Trigonometry.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kLampRadius = 0.045;  // of its distance: soft shadows whose casters remain recognizable

/// Term `index` of an additive recurrence in [0, 1); `step` irrational.
double quasirandom(int index, double step) {
    const double value = 0.5 + step * static_cast<double>(index);
    return value - std::floor(value);
}

/// Steps of a four-dimensional low-discrepancy sequence: powers of the inverse of the root of x^5 = x + 1.
constexpr double kSteps[] = {0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101};

}  // namespace

Environment environmentOf(Theme theme) {
    if (theme == Theme::Dark) {
        return {{0.27f, 0.29f, 0.33f, 1.0f},  {0.13f, 0.14f, 0.16f, 1.0f},
                {0.85f, 0.88f, 0.95f, 0.22f}, {0.25f, 0.95f, 0.85f, 1.0f},
                {0.82f, 0.86f, 0.92f, 1.0f},  0.6f,
                {0.07f, 0.09f, 0.14f},        {0.27f, 0.30f, 0.36f},
                {0.17f, 0.18f, 0.20f},        0.62f};
    }
    return {{0.99f, 0.99f, 1.0f, 1.0f}, {0.86f, 0.88f, 0.91f, 1.0f},
            {0.2f, 0.24f, 0.32f, 0.3f}, {0.0f, 0.42f, 0.5f, 1.0f},
            {0.16f, 0.2f, 0.27f, 1.0f}, 0.55f,
            {0.48f, 0.67f, 0.90f},      {0.90f, 0.93f, 0.96f},
            {0.80f, 0.79f, 0.76f},      1.05f};
}

Vec3 keyDirection() { return glm::normalize(Vec3(-0.45, 0.95, 0.62)); }

LightSample lightSample(int index) {
    const double fullTurn = 2.0 * std::numbers::pi;
    const Vec3 centre = keyDirection();
    const Vec3 right = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), centre)), up = glm::cross(centre, right);
    const double radius = kLampRadius * std::sqrt(quasirandom(index, kSteps[0]));
    const double angle = fullTurn * quasirandom(index, kSteps[1]);
    const double height = quasirandom(index, kSteps[2]), around = fullTurn * quasirandom(index, kSteps[3]);
    const double horizontal = std::sqrt(1.0 - height * height);
    return {index,
            glm::normalize(centre + radius * (cosine(angle) * right + sine(angle) * up)),
            {horizontal * cosine(around), height, horizontal * sine(around)},
            {quasirandom(index, kSteps[1]) - 0.5, quasirandom(index, kSteps[3]) - 0.5}};
}

}  // namespace rubble
