#include "core/fracture/PairIndex.h"
#include "core/fracture/PatternKind.h"
#include "core/fracture/PointNear.h"
#include "core/fracture/ScatterArea.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kUsualShare = 0.12;  // of the outline's diameter: how far a new layer's clusters reach

constexpr std::array kParameters{
    parameter<&Clusters::clusters>({.name = "clusters",
                                    .caption = "Clusters",
                                    .hint = "How many heaps of seeds; more leave the earlier ones where they are",
                                    .range = {0.0, kMostOfPair},
                                    .usual = {1.0, 50.0}}),
    parameter<&Clusters::seedsPerCluster>(
        {.name = "seedsPerCluster",
         .caption = "Seeds in each",
         .hint = "How many seeds a cluster has; more leave the earlier ones where they are",
         .range = {0.0, kMostOfPair},
         .usual = {1.0, 50.0}}),
    parameter<&Clusters::radius>(
        {.name = "radius",
         .caption = "Radius",
         .hint = "How far from its middle a cluster reaches; half of its seeds lie within half of it",
         .quantity = Quantity::Length,
         .range = kAboveZero,
         .usual = {0.005, 2.0, true}}),
};

bool isDeleted(const PatternLayer& layer, std::uint32_t seed) {
    const auto change = std::ranges::lower_bound(layer.overrides, seed, {}, &SeedOverride::index);
    return change != layer.overrides.end() && change->index == seed && change->isDeleted;
}

Report noRoom(const Clusters& layer, const LayerContext& context, std::size_t found) {
    const std::size_t wanted = std::size_t{layer.clusters} * layer.seedsPerCluster;
    return {ReportCode::NoRoom, kNone, context.layer.id, static_cast<double>(found),
            context.name() + " found room for " + std::to_string(found) + " of " + std::to_string(wanted) +
                " seeds: the outline is thin where its clusters are."};
}

}  // namespace

constinit const PatternKind Clusters::kKind{.name = "clusters",
                                            .caption = "Clusters",
                                            .hint = "Seeds in heaps, with room between them",
                                            .role = LayerRole::Scatters,
                                            .parameters = kParameters,
                                            .suitedTo = [](const Box2& bounds) -> LayerParameters {
                                                return Clusters{.radius = kUsualShare * bounds.diagonal()};
                                            }};

Status Clusters::apply(const LayerContext& context, SeedSet& seeds) const {
    const std::size_t wanted = std::size_t{clusters} * seedsPerCluster;
    if (wanted > kMostSeeds - seeds.size()) return tooManySeeds(context);
    const Result<ScatterArea> area = ScatterArea::of(context.outline);
    if (!area) return area.error();
    // Each cluster has a stream of its own, so that its seeds do not depend on how many the others have.
    std::vector<std::optional<Vec2>> positions(wanted);
    for (std::uint32_t cluster = 0; cluster < clusters; ++cluster) {
        Random random = context.randomOf(cluster);
        const Vec2 middle = area->point(random);
        for (std::size_t k = std::size_t{cluster} * seedsPerCluster, end = k + seedsPerCluster; k < end; ++k) {
            if (context.isCancelledAt(k)) return TaskContext::cancelled();
            positions[k] = pointNear(context.outline, middle, radius, random);
        }
    }
    const std::size_t before = seeds.size();
    for (const IndexPair pair : pairsBelow(clusters, seedsPerCluster)) {
        const std::optional<Vec2>& position = positions[std::size_t{pair.first} * seedsPerCluster + pair.second];
        const bool isThere = position || isDeleted(context.layer, pair.index());  // what is taken out needs no room
        if (isThere) seeds.add({context.layer.id, pair.index()}, position.value_or(Vec2(0.0)), false);
    }
    const std::size_t found = seeds.size() - before;
    if (found < wanted) seeds.reports.push_back(noRoom(*this, context, found));
    return success();
}

}  // namespace rubble
