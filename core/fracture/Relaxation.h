#pragma once

#include "core/fracture/Partition.h"
#include "core/fracture/PatternKindForward.h"

#include <functional>

namespace rubble {

/// More rounds move seeds by less than anybody sees, and a slip of the finger must not cost an hour.
inline constexpr std::uint32_t kMostRelaxationRounds = 1000;

/// The middle of all pieces of the seed whose first is `piece`; `seed` is where it lies now. Called by several threads.
using MiddleOfCell = std::function<Vec2(const Partition& partition, std::uint32_t piece, Vec2 seed)>;

/// Moves seeds to the middles of their cells, round after round. Those that are held, or have no cell, stay.
///
/// Errors: those of cellsOf(); Cancelled.
Status relax(std::uint32_t rounds, const LayerContext& context, SeedSet& seeds, const MiddleOfCell& middleOf);

}  // namespace rubble
