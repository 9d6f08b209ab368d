#include "core/fracture/kinds/Slices.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rubble {
namespace {

constexpr std::uint32_t kMaxCutsPerLayer = 2000;  // rotated cuts may all cross each other
constexpr double kOvershoot = 0.01;               // of the outline's extent, by which cuts exceed it
constexpr double kMaxAngleVariation = std::numbers::pi / 4.0;

constexpr std::array kSlicesParameters{
    parameter<&Slices::cuts>({.name = "cuts",
                              .caption = "Cuts",
                              .hint = "Number of cuts",
                              .range = {1.0, kMaxCutsPerLayer},
                              .sliderRange = {1.0, 50.0}}),
    parameter<&Slices::angle>({.name = "angle",
                               .caption = "Angle",
                               .hint = "Direction of the cuts; 0: horizontal; drag it in the canvas",
                               .quantity = Quantity::Angle,
                               .range = {-kMaxAngle, kMaxAngle},
                               .sliderRange = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&Slices::offsetVariation>({.name = "offsetVariation",
                                         .caption = "Offset variation",
                                         .hint = "0: equidistant cuts; 1: up to halfway to the next cut",
                                         .range = {0.0, 1.0},
                                         .sliderRange = {0.0, 1.0}}),
    parameter<&Slices::angleVariation>({.name = "angleVariation",
                                        .caption = "Angle variation",
                                        .hint = "Maximum rotation of a cut out of the common direction",
                                        .quantity = Quantity::Angle,
                                        .range = {0.0, kMaxAngleVariation},
                                        .sliderRange = {0.0, 0.5}}),
    parameter<&Slices::tilt>(tiltParameter("Tilt of the cuts about their direction; 90°: horizontal")),
};

/// One cut.
struct Cut {
    Vec2 pivot;
    Vec2 direction;
    bool liesBefore(Vec2 point) const { return cross(direction, point - pivot) < 0.0; }
};

/// The interval along its direction, in m, in which a cut lies in a box; the rest would only cross other cuts outside.
std::pair<double, double> intervalIn(const Box2& box, const Cut& cut) {
    double from = -HUGE_VAL, to = HUGE_VAL;
    for (const int axis : {0, 1}) {
        if (cut.direction[axis] == 0.0) continue;
        const double one = (box.min[axis] - cut.pivot[axis]) / cut.direction[axis];
        const double other = (box.max[axis] - cut.pivot[axis]) / cut.direction[axis];
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    }
    return {from, std::max(from, to)};
}

/// A sequence of nearly equidistant cuts; counts those before a point.
class CutRow {
public:
    /// Perpendicular to the direction, cut k is at lowest + step * (k + 1), with a deviation of at most half of
    /// `variation` steps; its pivot is at `middle` along the direction.
    CutRow(Vec2 direction, double middle, double lowest, double step, double variation)
        : m_direction(direction),
          m_middle(middle),
          m_lowest(lowest),
          m_step(step),
          m_deviation(variation / 2.0 + kSlack) {}

    void add(const Cut& cut) {
        m_cuts.push_back(cut);
        const double along = std::abs(glm::dot(cut.direction, m_direction));
        m_maxSlope = std::max(m_maxSlope, std::abs(cross(cut.direction, m_direction)) / along);
    }
    std::uint32_t countBefore(Vec2 point) const {
        const double count = static_cast<double>(m_cuts.size());
        const double position = (cross(point, m_direction) - m_lowest) / m_step - 1.0;  // in cut numbers
        const double rotated = std::abs(glm::dot(point, m_direction) - m_middle) * m_maxSlope / m_step;
        const auto certain = static_cast<std::uint32_t>(std::clamp(position - rotated - m_deviation, 0.0, count));
        const auto end = static_cast<std::uint32_t>(std::clamp(position + rotated + m_deviation + 1.0, 0.0, count));
        std::uint32_t before = certain;
        for (std::uint32_t k = certain; k < end; ++k) before += m_cuts[k].liesBefore(point);
        return before;
    }

private:
    static constexpr double kSlack = 1e-6;  // steps: far above rounding

    Vec2 m_direction;
    double m_middle;
    double m_lowest;
    double m_step;
    double m_deviation;       // steps
    double m_maxSlope = 0.0;  // of all cuts, relative to the direction
    std::vector<Cut> m_cuts;
};

}  // namespace

constinit const LayerKind Slices::kKind{.name = "slices",
                                        .caption = "Slices",
                                        .hint = "Straight cuts through the whole outline",
                                        .icon = "layer-slices",
                                        .summary = "{cuts|1 cut|%1 cuts}",
                                        .role = LayerRole::Cuts,
                                        .parameters = kSlicesParameters,
                                        .isRandom = true};

Status Slices::cut(const LayerContext& context, CutSet& set) const {
    const Vec2 direction(cosine(angle), sine(angle)), normal(direction.y, -direction.x);
    Box2 rotated;  // along the direction and the normal
    for (const Vec2 corner : context.outline.outer)
        rotated.include({glm::dot(corner, direction), glm::dot(corner, normal)});
    const double extent = 2.0 * rotated.diagonal(), middle = (rotated.min.x + rotated.max.x) / 2.0;
    const double step = rotated.size().y / (cuts + 1.0);
    Box2 around = boundsOf(context.outline.outer);
    around.min -= Vec2(kOvershoot * extent);
    around.max += Vec2(kOvershoot * extent);
    auto row = std::make_shared<CutRow>(direction, middle, rotated.min.y, step, offsetVariation);
    for (std::uint32_t k = 0; k < cuts; ++k) {
        if (context.isCancelledAt(k)) return TaskContext::cancelled();
        Random random = context.randomOf(k);
        const double offset = rotated.min.y + step * (k + 1.0 + offsetVariation * (random.unit() - 0.5));
        const double cutAngle = angle + angleVariation * (2.0 * random.unit() - 1.0);
        const Cut cut{middle * direction + offset * normal, {cosine(cutAngle), sine(cutAngle)}};
        row->add(cut);
        const auto [from, to] = intervalIn(around, cut);
        const std::uint32_t first = set.addPoint(cut.pivot + from * cut.direction);
        set.edges.push_back({first, set.addPoint(cut.pivot + to * cut.direction), k});
    }
    const bool isNoded = angleVariation == 0.0 && offsetVariation < 1.0;
    set.layers.push_back({context.layerId, static_cast<std::uint32_t>(set.edges.size()), isNoded,
                          [row](Vec2 point) { return row->countBefore(point); }});
    return success();
}

Status Slices::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    if (cuts + std::size_t{1} > kMaxSeeds - seeds.size()) return tooManySeeds(context);
    const Vec3 direction(cosine(angle), sine(angle), 0.0);
    const Vec3 normal(cosine(tilt) * direction.y, -cosine(tilt) * direction.x, sine(tilt));
    const Vec3 middle = context.domain.bounds().centre();
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Vec3 point : context.domain.mesh().points) {
        lowest = std::min(lowest, glm::dot(point - middle, normal));
        highest = std::max(highest, glm::dot(point - middle, normal));
    }
    const double step = (highest - lowest) / (cuts + 1.0);
    const Vec3 across = glm::cross(normal, direction);
    Vec2 aside(0.0);  // along direction and across
    double before = 0.0;
    for (std::uint32_t k = 0; k <= cuts; ++k) {
        if (context.isCancelledAt(k)) return TaskContext::cancelled();
        Random random = context.randomOf(k);
        const double offset = lowest + step * (k + 0.5 + offsetVariation * (random.unit() - 0.5));
        const double cutAngle = angleVariation * random.unit(), turn = kFullTurn * random.unit();
        const double slope = sine(cutAngle) / cosine(cutAngle);
        if (k > 0) aside += slope * (offset - before) * Vec2(cosine(turn), sine(turn));
        before = offset;
        seeds.add({context.layerId, k}, middle + offset * normal + aside.x * direction + aside.y * across, false);
    }
    return success();
}

double Slices::estimatedPiecesIn(const SolidDomain&) const { return cuts + 1.0; }

}  // namespace rubble
