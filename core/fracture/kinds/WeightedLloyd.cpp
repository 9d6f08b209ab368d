#include "core/fracture/kinds/WeightedLloyd.h"

#include "core/fracture/kinds/Relaxation.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/geometry/polygon/ConvexParts.h"

#include <glm/geometric.hpp>

namespace rubble {
namespace {

constexpr int kSubdivisions = 6;  // per side: each triangle of a cell is sampled at the centroids of their square

constexpr std::array kWeightedLloydParameters{
    parameter<&WeightedLloyd::rounds>(
        {.name = "rounds",
         .caption = "Rounds",
         .hint = "Number of times that the seeds above move to the centroids of their cells, weighted by the "
                 "images and impacts above",
         .range = {0.0, kMaxRelaxationRounds},
         .sliderRange = {0.0, 50.0}}),
};

/// The target density of the layers before, up to a factor: above zero, so that every cell has a centroid.
double targetDensity(const LayerContext& context, Vec2 point) {
    constexpr double kMinDensity = 1e-3;
    double sum = kMinDensity;
    for (const SeedDensity& density : context.densities) sum += density(point);
    return sum;
}

/// The moments of a cell.
struct WeightedCell {
    Vec2 moment{0.0, 0.0};
    double weight = 0.0;
};

/// Adds a triangle, sampled at the centroids of its equal subdivisions.
void addTriangle(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, const LayerContext& context, WeightedCell& cell) {
    const Vec2 first = (b - a) / static_cast<double>(kSubdivisions),
               second = (c - a) / static_cast<double>(kSubdivisions);
    const double size = cross(first, second) / 2.0;
    const auto add = [&](double u, double v) {
        const Vec2 point = a + u * first + v * second;
        const double target = targetDensity(context, origin + point), weight = target * target * size;
        cell.weight += weight;
        cell.moment += weight * point;
    };
    for (int i = 0; i < kSubdivisions; ++i) {
        for (int j = 0; i + j < kSubdivisions; ++j) {
            add(i + 1.0 / 3.0, j + 1.0 / 3.0);
            if (i + j + 1 < kSubdivisions) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
        }
    }
}

/// The weighted centroid of all pieces of a seed, which begin at `piece`; `fallback` if their weight is zero.
Vec2 centroidOfCell(const Partition& partition, std::uint32_t piece, const LayerContext& context, Vec2 fallback) {
    const std::uint32_t seed = partition.seedOfPiece[piece];
    WeightedCell cell;
    for (; piece < partition.pieceCount() && partition.seedOfPiece[piece] == seed; ++piece) {
        const Polygon outline = pieceOutline(partition, piece);
        const std::vector<Vec2> corners = cornersOf(outline);
        const Result<IndexLoops> parts = triangles(outline);
        if (!parts) continue;
        for (const std::vector<std::uint32_t>& part : *parts)
            addTriangle(corners[part[0]], corners[part[1]], corners[part[2]], partition.origin, context, cell);
    }
    return cell.weight > 0.0 ? partition.origin + cell.moment / cell.weight : fallback;
}

}  // namespace

constinit const LayerKind WeightedLloyd::kKind{
    .name = "weightedLloyd",
    .caption = "Weighted relaxation",
    .hint = "Evens out the layers above, weighted by their images and impacts",
    .icon = "layer-weighted-lloyd",
    .summary = "{rounds|1 round|%1 rounds}",
    .role = LayerRole::Moves,
    .parameters = kWeightedLloydParameters};

Status WeightedLloyd::apply(const LayerContext& context, SeedSet& seeds) const {
    return relax(rounds, context, seeds, [&](const Partition& partition, std::uint32_t piece, Vec2 seed) {
        return centroidOfCell(partition, piece, context, seed);
    });
}

}  // namespace rubble
