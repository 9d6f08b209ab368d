#include "core/fracture/Slices.h"

#include "core/base/Trigonometry.h"
#include "core/fracture/CutSet.h"
#include "core/fracture/PatternKind.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rubble {
namespace {

constexpr std::uint32_t kMostCutsOfLayer = 2000;  // where they are turned, all may cross each other
constexpr double kOvershoot = 0.01;               // of the outline's reach, that cuts go beyond it
constexpr double kMostTurn = std::numbers::pi / 4.0;

constexpr std::array kParameters{
    parameter<&Slices::cuts>({.name = "cuts",
                              .caption = "Cuts",
                              .hint = "How many cuts go right across",
                              .range = {1.0, kMostCutsOfLayer},
                              .usual = {1.0, 50.0}}),
    parameter<&Slices::angle>({.name = "angle",
                               .caption = "Angle",
                               .hint = "How the cuts run: 0 is level; it can be dragged in the canvas",
                               .quantity = Quantity::Angle,
                               .range = {-kLargestAngle, kLargestAngle},
                               .usual = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&Slices::offsetVariation>({.name = "offsetVariation",
                                         .caption = "Offset variation",
                                         .hint = "0: at equal distances; 1: anywhere up to half way to the next cut",
                                         .range = {0.0, 1.0},
                                         .usual = {0.0, 1.0}}),
    parameter<&Slices::angleVariation>({.name = "angleVariation",
                                        .caption = "Angle variation",
                                        .hint = "How far each cut is turned out of the common direction at most",
                                        .quantity = Quantity::Angle,
                                        .range = {0.0, kMostTurn},
                                        .usual = {0.0, 0.5}}),
};

/// One cut, and which points it lies before.
struct Cut {
    Vec2 pivot;
    Vec2 direction;
    bool liesBefore(Vec2 point) const { return cross(direction, point - pivot) < 0.0; }
};

/// From where to where along its direction a cut lies in a box, m: what lies outside would only cross other cuts there.
std::pair<double, double> stretchIn(const Box2& box, const Cut& cut) {
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

/// Cuts at equal distances but for what they vary, and how many of them lie before a point.
class CutRow {
public:
    /// Across the direction, the cut of number k comes at lowest + step * (k + 1) and off that by half of `variation` steps at
    /// most; its pivot lies at `middle` along the direction.
    CutRow(Vec2 direction, double middle, double lowest, double step, double variation)
        : m_direction(direction), m_middle(middle), m_lowest(lowest), m_step(step), m_reach(variation / 2.0 + kSlack) {}

    void add(const Cut& cut) {
        m_cuts.push_back(cut);
        const double along = std::abs(glm::dot(cut.direction, m_direction));
        m_steepest = std::max(m_steepest, std::abs(cross(cut.direction, m_direction)) / along);
    }
    std::uint32_t countBefore(Vec2 point) const {
        const double count = static_cast<double>(m_cuts.size());
        const double place = (cross(point, m_direction) - m_lowest) / m_step - 1.0;  // where a cut's number would be
        const double turned = std::abs(glm::dot(point, m_direction) - m_middle) * m_steepest / m_step;
        const auto certain = static_cast<std::uint32_t>(std::clamp(place - turned - m_reach, 0.0, count));
        const auto end = static_cast<std::uint32_t>(std::clamp(place + turned + m_reach + 1.0, 0.0, count));
        std::uint32_t before = certain;
        for (std::uint32_t k = certain; k < end; ++k) before += m_cuts[k].liesBefore(point);
        return before;
    }

private:
    static constexpr double kSlack = 1e-6;  // steps: far more than rounding takes

    Vec2 m_direction;
    double m_middle;
    double m_lowest;
    double m_step;
    double m_reach;           // steps
    double m_steepest = 0.0;  // of all cuts, against the direction
    std::vector<Cut> m_cuts;
};

}  // namespace

constinit const PatternKind Slices::kKind{.name = "slices",
                                          .caption = "Slices",
                                          .hint = "Straight cuts right across",
                                          .role = LayerRole::Cuts,
                                          .parameters = kParameters,
                                          .suitedTo = [](const Box2&) -> LayerParameters { return Slices{}; }};

Status Slices::cut(const LayerContext& context, CutSet& set) const {
    const Vec2 direction(cosine(angle), sine(angle)), normal(direction.y, -direction.x);
    Box2 turned;  // along the direction and the normal
    for (const Vec2 corner : context.outline.outer)
        turned.include({glm::dot(corner, direction), glm::dot(corner, normal)});
    const double reach = 2.0 * turned.diagonal(), middle = (turned.min.x + turned.max.x) / 2.0;
    const double step = turned.size().y / (cuts + 1.0);
    Box2 around = boundsOf(context.outline.outer);
    around.min -= Vec2(kOvershoot * reach);
    around.max += Vec2(kOvershoot * reach);
    auto row = std::make_shared<CutRow>(direction, middle, turned.min.y, step, offsetVariation);
    for (std::uint32_t k = 0; k < cuts; ++k) {
        if (context.isCancelledAt(k)) return TaskContext::cancelled();
        Random random = context.randomOf(k);
        const double place = turned.min.y + step * (k + 1.0 + offsetVariation * (random.unit() - 0.5));
        const double turn = angle + angleVariation * (2.0 * random.unit() - 1.0);
        const Cut cut{middle * direction + place * normal, {cosine(turn), sine(turn)}};
        row->add(cut);
        const auto [from, to] = stretchIn(around, cut);
        const std::uint32_t first = set.addPoint(cut.pivot + from * cut.direction);
        set.edges.push_back({first, set.addPoint(cut.pivot + to * cut.direction), k});
    }
    const bool isNoded = angleVariation == 0.0 && offsetVariation < 1.0;
    set.layers.push_back({context.layer.id, static_cast<std::uint32_t>(set.edges.size()), isNoded,
                          [row](Vec2 point) { return row->countBefore(point); }});
    return success();
}

}  // namespace rubble
