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
constexpr double kRoom = 1.0 + 1e-9;              // far more than rounding takes
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

/// The cuts in the order of their numbers, and how many lie before a point.
class CutRow {
public:
    CutRow(Vec2 direction, double reach) : m_normal(direction.y, -direction.x), m_reach(reach) {}

    void add(const Cut& cut) {
        const double place = glm::dot(cut.pivot, m_normal);
        const double lean = std::abs(glm::dot(cut.direction, m_normal)),
                     along = std::abs(cross(cut.direction, m_normal));
        const double slack = m_reach * lean / along;
        m_cuts.push_back(cut);
        m_lowest.push_back(place - slack);
        m_highest.push_back(m_highest.empty() ? place + slack : std::max(m_highest.back(), place + slack));
    }
    void finish() {
        for (std::size_t k = m_lowest.size(); k-- > 1;) m_lowest[k - 1] = std::min(m_lowest[k - 1], m_lowest[k]);
    }
    std::uint32_t countBefore(Vec2 point) const {
        const double place = glm::dot(point, m_normal);
        const auto certain = std::ranges::lower_bound(m_highest, place) - m_highest.begin();
        const auto end = std::ranges::upper_bound(m_lowest, place) - m_lowest.begin();
        auto count = static_cast<std::uint32_t>(certain);
        for (auto k = certain; k < end; ++k) count += m_cuts[static_cast<std::size_t>(k)].liesBefore(point);
        return count;
    }

private:
    Vec2 m_normal;
    double m_reach;  // m: along the direction, from the pivots to the ends of the outline
    std::vector<Cut> m_cuts;
    std::vector<double> m_highest;  // along the normal, of all cuts up to each
    std::vector<double> m_lowest;   // of all cuts from each on
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
    auto row = std::make_shared<CutRow>(direction, kRoom * turned.size().x / 2.0);
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
    row->finish();
    const bool isNoded = angleVariation == 0.0 && offsetVariation < 1.0;
    set.layers.push_back({context.layer.id, static_cast<std::uint32_t>(set.edges.size()), isNoded,
                          [row](Vec2 point) { return row->countBefore(point); }});
    return success();
}

}  // namespace rubble
