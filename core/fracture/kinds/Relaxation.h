#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/partition/Partition.h"

#include <functional>

namespace rubble {

/// The maximum number of rounds; beyond it, seeds hardly move.
inline constexpr std::uint32_t kMaxRelaxationRounds = 1000;

/// The centroid of all pieces of a seed, the first of which is `piece`; `seed` is its current position. Called by
/// several threads.
using CentroidOfCell = std::function<Vec2(const Partition& partition, std::uint32_t piece, Vec2 seed)>;

/// Moves seeds to the centroids of their cells, round after round. Locked seeds and those without a cell stay.
///
/// Errors: those of LayerContext::cellsOf(); Cancelled.
Status relax(std::uint32_t rounds, const LayerContext& context, SeedSet& seeds, const CentroidOfCell& centroidOf);

/// Moves seeds in a closed mesh to the centroids of their cells, round after round. Locked seeds and those without a
/// cell stay.
///
/// Errors: those of SolidLayerContext::cellsOf(); Cancelled.
Status relaxInSolid(std::uint32_t rounds, const SolidLayerContext& context, SeedSet& seeds);

}  // namespace rubble
