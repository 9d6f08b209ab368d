#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/layer/SeedDensity.h"
#include "core/fracture/layer/SeedId.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/sampling/SeedCount.h"
#include "core/fracture/sampling/SolidDomain.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/polygon/Polygon.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The seeds during the evaluation of a pattern.
struct SeedSet {
    std::vector<Vec2> positions;
    std::vector<double> heights;  // z of each, m; empty in the plane
    std::vector<SeedId> ids;      // one per position
    std::vector<bool> isLocked;   // placed or moved by hand: relaxation does not move it
    std::vector<Diagnostic> diagnostics;

    std::size_t size() const { return positions.size(); }
    Vec3 at(std::size_t seed) const { return {positions[seed], heights.empty() ? 0.0 : heights[seed]}; }
    /// Adds a seed in the plane, or one in space: all have to be of one sort.
    void add(SeedId id, Vec2 position, bool locked);
    void add(SeedId id, Vec3 position, bool locked);
    /// Reserves memory for additional seeds.
    void reserve(std::size_t additional);
    /// Removes the seeds from `first` on for which `isRemoved`, one each, is true.
    void remove(std::size_t first, const std::vector<bool>& isRemoved);
};

/// A layer during the evaluation of its pattern, in the plane or in space.
struct EvaluatedLayer {
    std::uint32_t layerId = 0;
    std::uint64_t randomSeed = 0;
    std::span<const SeedOverride> overrides;
    const TaskContext& task;

    /// The layer's own random stream, from its start.
    Random random() const { return Random(mixSeeds(randomSeed, layerId)); }
    /// The random stream of one of its seeds, cuts or clusters.
    Random randomOf(std::uint64_t index) const { return Random(mixSeeds(mixSeeds(randomSeed, layerId), index)); }
    /// The name of the layer for the start of a sentence: "Layer 4".
    std::string name() const;
    /// Whether the task is cancelled; tests only every 1024th round of a loop.
    bool isCancelledAt(std::size_t round) const { return round % 1024 == 0 && task.isCancelled(); }
};

/// The input of a layer's apply(), which adds seeds with ascending indices to those of the layers before, or moves
/// those.
struct LayerContext : EvaluatedLayer {
    const Polygon& outline;  // validated
    /// The cells of seeds, in the metric of the whole pattern. Errors: those of triangulate(); Cancelled.
    std::function<Result<Partition>(std::span<const Vec2>)> cellsOf = nullptr;
    std::vector<SeedDensity> densities = {};  // of the layers before
    const Polygon* scatteredIn = nullptr;     // validated; null: the outline

    /// The outline that seeds are scattered in; followOutline() then makes them fit the present one.
    const Polygon& scatterOutline() const { return scatteredIn ? *scatteredIn : outline; }
};

/// The input of a layer's applyInSolid(), which does the same in a closed mesh.
struct SolidLayerContext : EvaluatedLayer {
    const SolidDomain& domain;
    /// The cells of seeds, in the metric of the whole pattern. Errors: those of cutSolid().
    std::function<Result<SolidPartition>(std::span<const Vec3>)> cellsOf = nullptr;
};

/// The error of a pattern with too many seeds.
Error tooManySeeds(const EvaluatedLayer& layer);

/// The number of seeds of a count in a domain. Errors: Limit if there are too many, including the seeds of earlier
/// layers.
Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds);
/// The same in a volume, m³.
Result<std::uint32_t> seedsToAdd(const SeedCount& count, double volume, const SolidLayerContext& context,
                                 const SeedSet& seeds);

/// The error of a lattice in space with more cells along one side than tripleIndex() can number: "Layer 4 has 2000
/// columns, but 1600 is the maximum on a mesh."
Error tooManyNumbers(const SolidLayerContext& context, const char* what, double count);

/// A seed of a lattice in space.
struct IndexedPlace {
    std::uint32_t index = 0;
    Vec3 position{0.0};
};
/// Adds seeds in the order of their indices.
void addByIndex(std::vector<IndexedPlace>& places, const SolidLayerContext& context, SeedSet& seeds);

/// Adds `count` seeds at area.point(random), one after the other. Errors: Cancelled.
template <class Area>
Status scatter(std::uint32_t count, const Area& area, const EvaluatedLayer& context, SeedSet& seeds) {
    Random random = context.random();
    seeds.reserve(count);
    for (std::uint32_t index = 0; index < count; ++index) {
        if (context.isCancelledAt(index)) return TaskContext::cancelled();
        seeds.add({context.layerId, index}, area.point(random), false);
    }
    return success();
}

}  // namespace rubble
