#include "core/asset/finish/FinishedSurface.h"

#include "core/asset/finish/FinishNoise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {
namespace {

constexpr double kLapShade = 0.75;  // of the light that is lost beside the edge of a course
constexpr double kLapRun = 0.85;    // the part of a course from its top to its highest place

double smoothstep(double low, double high, double value) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Source: Jarzynski, Olano, "Hash functions for GPU rendering", 2020 (PCG).
double randomOf(int column, int row) {
    const std::uint32_t state =
        (static_cast<std::uint32_t>(column & 4095) + 4096u * static_cast<std::uint32_t>(row & 4095)) * 747796405u +
        2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return static_cast<double>(((word >> 22u) ^ word) & 0xffffu) / 65536.0;
}

/// Along the courses and across them, m: the plane that a face is nearest to.
Vec2 courseCoordinates(Vec3 point, Vec3 normal) {
    const Vec3 size = glm::abs(normal);
    if (size.z >= size.x && size.z >= size.y) return {point.x, point.y};
    return size.y >= size.x ? Vec2(point.x, point.z) : Vec2(point.z, point.y);
}

/// The point with the axis of the grain first.
Vec3 alongGrain(Vec3 point, int axis) { return {point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]}; }

}  // namespace

FinishedSurface finishedSurface(const FinishParameters& parameters, Vec3 point, Vec3 normal, Vec3 colour,
                                Vec2 courseOrigin, int grainAxis) {
    const FinishParameters& p = parameters;
    const Vec3 place = alongGrain(point, grainAxis);
    const Vec3 stretched = place * Vec3(1.0 / static_cast<double>(p.stretch), 1.0, 1.0);
    const auto broad = FinishNoise::shared().at(static_cast<double>(p.broadScale) * stretched);
    const auto fine = FinishNoise::shared().at(static_cast<double>(p.fineScale) * stretched);
    const double distance = glm::length((place - Vec3(p.bandCentre)) * Vec3(p.bandAxes));
    const double bands = (distance + p.warp * (broad[0] - 0.5)) * p.bandCentre.w, t = bands - std::floor(bands);
    const double band = p.bandCentre.w > 0.0f ? t * (1.0 - smoothstep(0.7, 1.0, t)) : 0.35;
    const double speck = 1.0 - smoothstep(p.speckSize - p.speckSoftness, p.speckSize + p.speckSoftness, fine[2]);
    const double tone =
        1.0 + p.broadTone * (2.0 * broad[0] - 1.0) + p.fineTone * (2.0 * fine[1] - 1.0) + p.bandTone * (band - 0.35);
    FinishedSurface surface{.albedo = colour * tone};
    surface.albedo *= glm::mix(Vec3(1.0), Vec3(p.stain), p.stain.w * smoothstep(0.5, 0.8, broad[1]));
    surface.albedo = glm::mix(surface.albedo, colour * Vec3(p.speck) * (0.7 + 0.6 * fine[3]),
                              static_cast<double>(p.speck.w) * speck);
    surface.height = p.broadHeight * broad[0] + p.fineHeight * fine[0] + p.bandHeight * band + p.speckHeight * speck;
    surface.roughness = p.roughness + p.roughnessTone * (2.0 * fine[1] - 1.0);
    surface.metalness = p.bandAxes.w;
    if (p.courseTone != 0.0f) {
        const bool isAlongGrain = p.hasCoursesAlongGrain;
        const Vec2 offset =
            courseCoordinates(isAlongGrain ? place : point, isAlongGrain ? alongGrain(normal, grainAxis) : normal) -
            courseOrigin;
        const Vec2 size(p.courses.x, p.courses.y);
        const double row = std::floor(offset.y / size.y);
        const double along = offset.x / size.x + p.joint.w * (row - 2.0 * std::floor(0.5 * row));
        const double column = std::floor(along), u = along - column, v = offset.y / size.y - row;
        const double below = 1.0 - smoothstep(0.0, p.lapShade, (1.0 - v) * size.y);
        surface.albedo *= 1.0 - (p.lapShade > 0.0f ? kLapShade * below : 0.0);
        surface.height += p.lap * std::min((1.0 - v) / kLapRun, v / (1.0 - kLapRun));
        const double edge = std::min(std::min(u, 1.0 - u) * size.x, std::min(v, 1.0 - v) * size.y);
        const double width = p.courses.z, inner = (edge - 0.5 * width) / (0.3 * width);
        const double joint = width > 0.0 ? 1.0 - smoothstep(-0.5, 0.5, inner) : 0.0;
        const double random = randomOf(static_cast<int>(column), static_cast<int>(row));
        surface.albedo = glm::mix(surface.albedo * (1.0 + p.courseTone * (2.0 * random - 1.0)),
                                  Vec3(p.joint) * (0.85 + 0.3 * fine[0]), joint);
        surface.height = glm::mix(surface.height, static_cast<double>(p.courses.w), joint);
        surface.roughness = glm::mix(surface.roughness, 0.95, joint);
        surface.metalness *= 1.0 - joint;
    }
    surface.albedo = glm::clamp(surface.albedo, Vec3(0.0), Vec3(1.0));
    surface.roughness = std::clamp(surface.roughness, 0.03, 1.0);
    return surface;
}

}  // namespace rubble
