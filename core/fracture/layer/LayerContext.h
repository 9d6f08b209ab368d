#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/layer/SeedDensity.h"
#include "core/fracture/layer/SeedId.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/sampling/SeedCount.h"
#include "core/geometry/polygon/Polygon.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The seeds during the evaluation of a pattern.
struct SeedSet {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;     // one per position
    std::vector<bool> isLocked;  // placed or moved by hand: relaxation does not move it
    std::vector<Diagnostic> diagnostics;

    std::size_t size() const { return positions.size(); }
    void add(SeedId id, Vec2 position, bool locked);
    /// Reserves memory for additional seeds.
    void reserve(std::size_t additional);
    /// Removes the seeds from `first` on for which `isRemoved`, one each, is true.
    void remove(std::size_t first, const std::vector<bool>& isRemoved);
};

/// The input of a layer's apply(), which adds seeds with ascending indices to those of the layers before, or moves
/// those.
struct LayerContext {
    std::uint32_t layerId = 0;
    std::uint64_t randomSeed = 0;
    std::span<const SeedOverride> overrides;
    const Polygon& outline;  // validated
    const TaskContext& task;
    /// The cells of seeds, in the metric of the whole pattern. Errors: those of triangulate(); Cancelled.
    std::function<Result<Partition>(std::span<const Vec2>)> cellsOf = nullptr;
    std::vector<SeedDensity> densities = {};  // of the layers before
    const Polygon* scatteredIn = nullptr;     // validated; null: the outline

    /// The outline that seeds are scattered in; followOutline() then makes them fit the present one.
    const Polygon& scatterOutline() const { return scatteredIn ? *scatteredIn : outline; }
    /// The layer's own random stream, from its start.
    Random random() const { return Random(mixSeeds(randomSeed, layerId)); }
    /// The random stream of one of its seeds, cuts or clusters.
    Random randomOf(std::uint64_t index) const { return Random(mixSeeds(mixSeeds(randomSeed, layerId), index)); }
    /// The name of the layer for the start of a sentence: "Layer 4".
    std::string name() const;
    /// Whether the task is cancelled; tests only every 1024th round of a loop.
    bool isCancelledAt(std::size_t round) const { return round % 1024 == 0 && task.isCancelled(); }
};

/// The error of a pattern with too many seeds.
Error tooManySeeds(const LayerContext& context);

/// The number of seeds of a count in a domain. Errors: Limit if there are too many, including the seeds of earlier
/// layers.
Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds);

/// Adds `count` seeds at area.point(random), one after the other. Errors: Cancelled.
template <class Area>
Status scatter(std::uint32_t count, const Area& area, const LayerContext& context, SeedSet& seeds) {
    Random random = context.random();
    seeds.reserve(count);
    for (std::uint32_t index = 0; index < count; ++index) {
        if (context.isCancelledAt(index)) return TaskContext::cancelled();
        seeds.add({context.layerId, index}, area.point(random), false);
    }
    return success();
}

}  // namespace rubble
