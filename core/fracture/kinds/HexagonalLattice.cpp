#include "core/fracture/kinds/HexagonalLattice.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kDefaultLatticeColumns = 6.0;           // cells along the longer side in a new layer
constexpr double kMaxLatticeSteps = kMaxPairNumber / 2;  // from the centre, in each direction of the lattice
constexpr double kRowHeight = std::numbers::sqrt3 / 2.0;

constexpr std::array kHexagonalLatticeParameters{
    parameter<&HexagonalLattice::spacing>({.name = "spacing",
                                           .caption = "Spacing",
                                           .hint = "Distance between neighbouring seeds",
                                           .quantity = Quantity::Length,
                                           .range = kAboveZero,
                                           .sliderRange = {0.01, 2.0, true}}),
    parameter<&HexagonalLattice::rotation>({.name = "rotation",
                                            .caption = "Rotation",
                                            .hint = "Rotation of the lattice; 0: horizontal rows",
                                            .quantity = Quantity::Angle,
                                            .range = {-kMaxAngle, kMaxAngle},
                                            .sliderRange = {-std::numbers::pi / 6.0, std::numbers::pi / 6.0}}),
    parameter<&HexagonalLattice::domain>(kDomainParameter),
};

/// The multiples of `step` that keep `from + k * step` in [min, max]: intersects the range [first, last].
void limit(double from, double step, double min, double max, double& first, double& last) {
    if (step == 0.0) {
        if (from < min || from > max) last = first - 1.0;
        return;
    }
    const double one = (min - from) / step, other = (max - from) / step;
    first = std::max(first, std::ceil(std::min(one, other)));
    last = std::min(last, std::floor(std::max(one, other)));
}

struct LatticePoint {
    std::uint32_t index;
    Vec2 position;
};

}  // namespace

constinit const LayerKind HexagonalLattice::kKind{.name = "hexagonal",
                                                  .caption = "Hexagonal lattice",
                                                  .hint = "Seeds whose cells are regular hexagons",
                                                  .icon = "layer-hexagonal",
                                                  .summary = "{spacing} apart",
                                                  .role = LayerRole::Scatters,
                                                  .parameters = kHexagonalLatticeParameters,
                                                  .fillsOutline = true};

HexagonalLattice HexagonalLattice::defaultsFor(const Box2& bounds) {
    return {.spacing = std::max(bounds.size().x, bounds.size().y) / kDefaultLatticeColumns};
}

Status HexagonalLattice::apply(const LayerContext& context, SeedSet& seeds) const {
    const Box2 box = boundsOf(context.outline.outer), scattered = boundsOf(context.scatterOutline().outer);
    const Vec2 centre = (scattered.min + scattered.max) / 2.0;
    const Vec2 along = spacing * Vec2(cosine(rotation), sine(rotation));
    const Vec2 across = along / 2.0 + kRowHeight * perpendicular(along);
    const double extent = context.scatteredIn ? box.diagonal() + scattered.diagonal() +
                                                    2.0 * glm::distance(centre, (box.min + box.max) / 2.0)
                                              : box.diagonal();
    const double steps = std::ceil(extent / (2.0 * kRowHeight * spacing));
    if (!(steps < kMaxLatticeSteps)) {
        return Error{ErrorCode::Limit, context.name() + " has seeds more than " +
                                           std::to_string(static_cast<int>(kMaxLatticeSteps)) +
                                           " steps from its centre: increase the spacing."};
    }
    std::vector<LatticePoint> points;
    for (double row = -steps; row <= steps; ++row) {
        const Vec2 start = centre + row * across;
        double first = -2.0 * steps, last = 2.0 * steps;
        limit(start.x, along.x, box.min.x, box.max.x, first, last);
        limit(start.y, along.y, box.min.y, box.max.y, first, last);
        for (double column = first; column <= last; ++column) {
            if (context.isCancelledAt(points.size())) return TaskContext::cancelled();
            if (points.size() >= kMaxSeeds - seeds.size()) return tooManySeeds(context);
            const std::uint32_t index = pairIndex(zigzag(static_cast<int>(column)), zigzag(static_cast<int>(row)));
            points.push_back({index, start + column * along});
        }
    }
    std::ranges::sort(points, {}, &LatticePoint::index);
    seeds.reserve(points.size());
    const ContainmentIndex outline(context.outline);
    for (const LatticePoint& point : points) {
        if (context.isCancelledAt(point.index)) return TaskContext::cancelled();
        const bool isOutside = domain == ScatterDomain::Outline && outline.of(point.position) == Containment::Outside;
        if (!isOutside) seeds.add({context.layerId, point.index}, point.position, false);
    }
    return success();
}

double HexagonalLattice::estimatedPieces(double area) const {
    return 2.0 / std::numbers::sqrt3 * area / spacing / spacing;
}

}  // namespace rubble
