#include "core/fracture/kinds/HexagonalLattice.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/fracture/sampling/SolidScatterDomain.h"
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
    parameter<&HexagonalLattice::layerHeight>({.name = "layerHeight",
                                               .caption = "Layer height",
                                               .hint = "Height of layers along z; 0: columns through the whole mesh",
                                               .quantity = Quantity::Length,
                                               .range = {0.0, std::numeric_limits<double>::max()},
                                               .sliderRange = {0.0, 2.0},
                                               .isSpatial = true}),
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
    int column = 0;
    int row = 0;
    Vec2 position{0.0, 0.0};
};

/// The points of a lattice around a centre that lie in a box, none of which is farther than `extent` from the centre.
///
/// Errors: Limit if there are more than `room`, or more than `maxSteps` from the centre; Cancelled.
Result<std::vector<LatticePoint>> latticePoints(const HexagonalLattice& lattice, const EvaluatedLayer& context,
                                                const Box2& box, Vec2 centre, double extent, double maxSteps,
                                                std::size_t room) {
    const Vec2 along = lattice.spacing * Vec2(cosine(lattice.rotation), sine(lattice.rotation));
    const Vec2 across = along / 2.0 + kRowHeight * perpendicular(along);
    const double steps = std::ceil(extent / (2.0 * kRowHeight * lattice.spacing));
    if (!(steps < maxSteps)) {
        return Error{ErrorCode::Limit, context.name() + " has seeds more than " +
                                           std::to_string(static_cast<int>(maxSteps)) +
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
            if (points.size() >= room) return tooManySeeds(context);
            points.push_back({static_cast<int>(column), static_cast<int>(row), start + column * along});
        }
    }
    return points;
}

/// The layers of a lattice in a mesh: how far they are from the middle, in m, in the order of their numbers.
std::vector<double> layerOffsets(double height, double layerHeight) {
    if (layerHeight == 0.0) return {0.0};
    const double onEachSide = std::floor(std::min(height / (2.0 * layerHeight), 1.0 * kMaxTripleNumber));
    std::vector<double> offsets;
    for (std::uint32_t layer = 0; layer <= 2.0 * onEachSide; ++layer) offsets.push_back(layerHeight * zigzagged(layer));
    return offsets;
}

}  // namespace

constinit const LayerKind HexagonalLattice::kKind{.name = "hexagonal",
                                                  .caption = "Hexagonal lattice",
                                                  .hint = "Seeds whose cells are regular hexagons",
                                                  .icon = "layer-hexagonal",
                                                  .summary = "{spacing} apart",
                                                  .role = LayerRole::Scatters,
                                                  .parameters = kHexagonalLatticeParameters,
                                                  .fillsOutline = true};

HexagonalLattice HexagonalLattice::defaultsFor(const Box3& bounds) {
    const Vec3 size = bounds.max - bounds.min;
    return {.spacing = std::max(size.x, size.y) / kDefaultLatticeColumns};
}

Status HexagonalLattice::apply(const LayerContext& context, SeedSet& seeds) const {
    const Box2 box = boundsOf(context.outline.outer), scattered = boundsOf(context.scatterOutline().outer);
    const Vec2 centre = (scattered.min + scattered.max) / 2.0;
    const double extent = context.scatteredIn ? box.diagonal() + scattered.diagonal() +
                                                    2.0 * glm::distance(centre, (box.min + box.max) / 2.0)
                                              : box.diagonal();
    Result<std::vector<LatticePoint>> points =
        latticePoints(*this, context, box, centre, extent, kMaxLatticeSteps, kMaxSeeds - seeds.size());
    if (!points) return points.error();
    const auto indexOf = [](const LatticePoint& point) { return pairIndex(zigzag(point.column), zigzag(point.row)); };
    std::ranges::sort(*points, {}, indexOf);
    seeds.reserve(points->size());
    const ContainmentIndex outline(context.outline);
    for (const LatticePoint& point : *points) {
        if (context.isCancelledAt(indexOf(point))) return TaskContext::cancelled();
        const bool isOutside = domain == ScatterDomain::Outline && outline.of(point.position) == Containment::Outside;
        if (!isOutside) seeds.add({context.layerId, indexOf(point)}, point.position, false);
    }
    return success();
}

Status HexagonalLattice::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    constexpr double kMaxSteps = kMaxTripleNumber / 4;  // columns may be twice as many as steps
    const Box3& bounds = context.domain.bounds();
    const Vec3 centre = bounds.centre();
    const std::vector<double> offsets = layerOffsets(bounds.max.z - bounds.min.z, layerHeight);
    if (offsets.size() > kMaxTripleNumber)
        return tooManyNumbers(context, "layers", (bounds.max.z - bounds.min.z) / layerHeight);
    const Box2 box{Vec2(bounds.min), Vec2(bounds.max)};
    const std::size_t room = (kMaxSeeds - seeds.size()) / offsets.size();
    const Result<std::vector<LatticePoint>> points =
        latticePoints(*this, context, box, Vec2(centre), box.diagonal(), kMaxSteps, room);
    if (!points) return points.error();
    std::vector<IndexedPlace> places;
    std::size_t round = 0;
    for (std::uint32_t layer = 0; layer < offsets.size(); ++layer) {
        for (const LatticePoint& point : *points) {
            if (context.isCancelledAt(round++)) return TaskContext::cancelled();
            const Vec3 place(point.position, centre.z + offsets[layer]);
            if (!SolidScatterDomain{context.domain, domain}.contains(place)) continue;
            places.push_back({tripleIndex(zigzag(point.column), zigzag(point.row), layer), place});
        }
    }
    addByIndex(places, context, seeds);
    return success();
}

double HexagonalLattice::estimatedPiecesIn(const SolidDomain& solid) const {
    const SolidScatterDomain filled{solid, domain};
    const double layers = layerHeight == 0.0 ? 1.0 : std::max(1.0, filled.size().z / layerHeight);
    return estimatedPieces(filled.volume() / filled.size().z) * layers;
}

double HexagonalLattice::estimatedPieces(double area) const {
    return 2.0 / std::numbers::sqrt3 * area / spacing / spacing;
}

}  // namespace rubble
