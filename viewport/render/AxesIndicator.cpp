#include "viewport/render/AxesIndicator.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace rubble {
namespace {

// In points.
constexpr double kCentre = 46.0, kArm = 26.0, kKnob = 8.0, kThickness = 1.3, kAxisLetter = 3.1, kAxisPen = 0.8;

constexpr std::array<glm::vec3, 3> kColours = {{{0.90f, 0.27f, 0.30f}, {0.36f, 0.68f, 0.22f}, {0.22f, 0.50f, 0.92f}}};

/// Line segments of the axis labels, in [-1, 1].
using Segment = std::array<double, 4>;
std::vector<Segment> letterOf(int axis) {
    if (axis == 0) return {{-1, -1, 1, 1}, {-1, 1, 1, -1}};
    if (axis == 1) return {{-1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 0, -1}};
    return {{-1, 1, 1, 1}, {1, 1, -1, -1}, {-1, -1, 1, -1}};
}

struct Arm {
    int axis;
    Vec2 end;      // points from the centre
    double depth;  // towards the eye
};

std::array<Arm, 3> armsOf(const Camera& camera) {
    const CameraAxes axes = axesOf(camera);
    std::array<Arm, 3> arms;
    for (int axis = 0; axis < 3; ++axis) {
        arms[static_cast<std::size_t>(axis)] = {axis, kArm * Vec2(axes.right[axis], axes.up[axis]), axes.back[axis]};
    }
    std::ranges::stable_sort(arms, {}, &Arm::depth);
    return arms;
}

}  // namespace

std::vector<ScreenLine> axesIndicator(const Camera& camera, double scale) {
    std::vector<ScreenLine> lines;
    const auto add = [&](Vec2 from, Vec2 to, glm::vec4 colour, double radius) {
        const Vec2 a = scale * (Vec2(kCentre) + from), b = scale * (Vec2(kCentre) + to);
        lines.push_back({glm::vec4(glm::dvec4(a, b)), colour, static_cast<float>(scale * radius)});
    };
    for (const Arm& arm : armsOf(camera)) {
        const float opacity = arm.depth < -0.05 ? 0.55f : 1.0f;
        const glm::vec4 colour(kColours[static_cast<std::size_t>(arm.axis)], opacity);
        if (glm::length(arm.end) > kKnob) add({0.0, 0.0}, arm.end, colour, kThickness);
        add(arm.end, arm.end, colour, kKnob);
        for (const auto& [x0, y0, x1, y1] : letterOf(arm.axis)) {
            add(arm.end + kAxisLetter * Vec2(x0, y0), arm.end + kAxisLetter * Vec2(x1, y1), glm::vec4(1.0f), kAxisPen);
        }
    }
    return lines;
}

}  // namespace rubble
