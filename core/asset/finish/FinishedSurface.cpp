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

/// Along the courses and up, m: in the plane of two axes that a face is nearest to. On a face across `up`, along the
/// two others.
Vec2 courseCoordinates(Vec3 point, Vec3 normal, int up) {
    const Vec3 size = glm::abs(normal);
    const int across = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0, rising = std::abs(up) - 1;
    if (across == rising) return {point[(rising + 2) % 3], point[(rising + 1) % 3]};
    return {point[3 - across - rising], up < 0 ? -point[rising] : point[rising]};
}

/// A point or a direction with an axis as the first.
Vec3 along(Vec3 vector, int axis) { return {vector[axis], vector[(axis + 1) % 3], vector[(axis + 2) % 3]}; }

/// A place among courses.
struct CoursePlace {
    int column = 0, row = 0;
    Vec2 part{0.0};  // of the brick with its joint, from its lower left corner
    Vec2 size{1.0};  // m, of both
};

/// `offset`: m, from the origin of the courses.
CoursePlace placeIn(const CourseForm& form, Vec2 offset) {
    const double height = form.height, row = std::floor(offset.y / height);
    const bool isOdd = row - 2.0 * std::floor(0.5 * row) > 0.5;
    const std::array<float, 2>& lengths = isOdd ? form.odd : form.even;
    const double first = lengths[0], period = first + lengths[1];
    const double from = isOdd ? offset.x - form.oddStart : offset.x, pair = std::floor(from / period);
    const double rest = from - pair * period;
    const bool isSecond = rest >= first;
    const double length = isSecond ? lengths[1] : lengths[0];
    return {.column = static_cast<int>(2.0 * pair) + (isSecond ? 1 : 0),
            .row = static_cast<int>(row),
            .part = {(isSecond ? rest - first : rest) / length, offset.y / height - row},
            .size = {length, height}};
}

void addCourses(FinishedSurface& surface, const FinishParameters& p, const CoursePlace& place, double fine) {
    const Vec2 part = place.part;
    const double below = 1.0 - smoothstep(0.0, p.lapShade, (1.0 - part.y) * place.size.y);
    surface.albedo *= 1.0 - (p.lapShade > 0.0f ? kLapShade * below : 0.0);
    surface.height += p.lap * std::min((1.0 - part.y) / kLapRun, part.y / (1.0 - kLapRun));
    const Vec2 apart = glm::min(part, 1.0 - part) * place.size;
    const double width = p.jointWidth, inner = (std::min(apart.x, apart.y) - 0.5 * width) / (0.3 * width);
    const double joint = width > 0.0 ? 1.0 - smoothstep(-0.5, 0.5, inner) : 0.0;
    const double random = randomOf(place.column, place.row);
    surface.albedo = glm::mix(surface.albedo * (1.0 + p.courseTone * (2.0 * random - 1.0)),
                              Vec3(p.joint) * (0.85 + 0.3 * fine), joint);
    surface.height = glm::mix(surface.height, static_cast<double>(p.jointHeight), joint);
    surface.roughness = glm::mix(surface.roughness, 0.95, joint);
    surface.metalness *= 1.0 - joint;
}

}  // namespace

FinishedSurface finishedSurface(const FinishParameters& parameters, Vec3 point, Vec3 normal, Vec3 colour,
                                const FinishFrame& frame) {
    const FinishParameters& p = parameters;
    const Vec3 place = along(point, frame.grainAxis);
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
    if (p.courseTone != 0.0f)
        addCourses(surface, p, placeIn(p.courses, courseCoordinates(point, normal, frame.up) - frame.courseOrigin),
                   fine[0]);
    surface.albedo = glm::clamp(surface.albedo, Vec3(0.0), Vec3(1.0));
    surface.roughness = std::clamp(surface.roughness, 0.03, 1.0);
    return surface;
}

}  // namespace rubble
