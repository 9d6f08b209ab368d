#include "core/fracture/kinds/Clusters.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/fracture/sampling/PointNear.h"
#include "core/fracture/sampling/ScatterArea.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kDefaultClusterFraction = 0.12;  // of the outline's diameter: the radius in a new layer

constexpr std::array kClustersParameters{
    parameter<&Clusters::clusters>({.name = "clusters",
                                    .caption = "Clusters",
                                    .hint = "Number of clusters; adding more keeps existing ones in place",
                                    .range = {0.0, kMaxPairNumber},
                                    .sliderRange = {1.0, 50.0}}),
    parameter<&Clusters::seedsPerCluster>(
        {.name = "seedsPerCluster",
         .caption = "Seeds per cluster",
         .hint = "Number of seeds in each cluster; adding more keeps existing ones in place",
         .range = {0.0, kMaxPairNumber},
         .sliderRange = {1.0, 50.0}}),
    parameter<&Clusters::radius>({.name = "radius",
                                  .caption = "Radius",
                                  .hint = "Radius of a cluster; half of its seeds lie within half the radius",
                                  .quantity = Quantity::Length,
                                  .range = kAboveZero,
                                  .sliderRange = {0.005, 2.0, true}}),
};

bool isDeleted(std::span<const SeedOverride> overrides, std::uint32_t seed) {
    const auto change = std::ranges::lower_bound(overrides, seed, {}, &SeedOverride::index);
    return change != overrides.end() && change->index == seed && change->isDeleted;
}

Diagnostic noRoom(const Clusters& layer, const EvaluatedLayer& context, std::string_view domain, std::size_t found) {
    const std::size_t wanted = std::size_t{layer.clusters} * layer.seedsPerCluster;
    return diagnostic(DiagnosticCode::NoRoom, {.layer = context.layerId},
                      context.name() + " found room for " + std::to_string(found) + " of " + std::to_string(wanted) +
                          " seeds: the " + std::string(domain) + " is thin where its clusters are.",
                      static_cast<double>(found));
}

/// Adds the seeds of all clusters that have a position, in the order of their indices.
template <class Point>
void addPairs(const Clusters& layer, const std::vector<std::optional<Point>>& positions, const EvaluatedLayer& context,
              std::string_view domain, SeedSet& seeds) {
    const std::size_t before = seeds.size();
    for (const IndexPair pair : pairsBelow(layer.clusters, layer.seedsPerCluster)) {
        const std::optional<Point>& position = positions[std::size_t{pair.first} * layer.seedsPerCluster + pair.second];
        const bool exists = position || isDeleted(context.overrides, pair.index());  // a deleted seed needs no position
        if (exists) seeds.add({context.layerId, pair.index()}, position.value_or(Point(0.0)), false);
    }
    const std::size_t found = seeds.size() - before;
    if (found < positions.size()) seeds.diagnostics.push_back(noRoom(layer, context, domain, found));
}

}  // namespace

constinit const LayerKind Clusters::kKind{.name = "clusters",
                                          .caption = "Clusters",
                                          .hint = "Groups of seeds with space between them",
                                          .icon = "layer-clusters",
                                          .summary = "{clusters} of {seedsPerCluster|1 seed|%1 seeds}",
                                          .role = LayerRole::Scatters,
                                          .parameters = kClustersParameters,
                                          .isRandom = true,
                                          .fillsOutline = true};

Clusters Clusters::defaultsFor(const Box3& bounds) {
    return Clusters{.radius = kDefaultClusterFraction * bounds.diagonal()};
}

Status Clusters::apply(const LayerContext& context, SeedSet& seeds) const {
    const std::size_t wanted = std::size_t{clusters} * seedsPerCluster;
    if (wanted > kMaxSeeds - seeds.size()) return tooManySeeds(context);
    const Result<ScatterArea> area = ScatterArea::of(context.scatterOutline());
    if (!area) return area.error();
    // Each cluster has its own random stream, so that its seeds do not depend on the number in the others.
    std::vector<std::optional<Vec2>> positions(wanted);
    for (std::uint32_t cluster = 0; cluster < clusters; ++cluster) {
        Random random = context.randomOf(cluster);
        const Vec2 centre = area->point(random);
        for (std::size_t k = std::size_t{cluster} * seedsPerCluster, end = k + seedsPerCluster; k < end; ++k) {
            if (context.isCancelledAt(k)) return TaskContext::cancelled();
            positions[k] = pointNear(context.scatterOutline(), centre, radius, random);
        }
    }
    const std::size_t before = seeds.size();
    addPairs(*this, positions, context, "outline", seeds);
    return followOutline(context, before, ScatterDomain::Outline, seeds);
}

Status Clusters::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const std::size_t wanted = std::size_t{clusters} * seedsPerCluster;
    if (wanted > kMaxSeeds - seeds.size()) return tooManySeeds(context);
    std::vector<std::optional<Vec3>> positions(wanted);
    for (std::uint32_t cluster = 0; cluster < clusters; ++cluster) {
        Random random = context.randomOf(cluster);
        const Vec3 centre = context.domain.point(random);
        for (std::size_t k = std::size_t{cluster} * seedsPerCluster, end = k + seedsPerCluster; k < end; ++k) {
            if (k % 64 == 0 && context.task.isCancelled()) return TaskContext::cancelled();
            positions[k] = pointNear(context.domain, centre, radius, random);
        }
    }
    addPairs(*this, positions, context, "mesh", seeds);
    return success();
}

double Clusters::estimatedPiecesIn(const SolidDomain&) const { return estimatedPieces(0.0); }

}  // namespace rubble
