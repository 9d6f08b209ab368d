#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/pieces/Prism.h"

namespace rubble {

/// Extrudes a partition: one fragment per piece, with convex hulls, mass properties and contacts (shared length *
/// depth, if the length is more than kMinSharedEdge of the outline's diameter). A piece too thin for a hull (its width
/// below 1e-9 of the outline's, see widthOf) is reported, and its mass is transferred to the neighbour with the longest
/// shared edge (see massTransfersOf); the receiver inherits its contacts and replaces it as edge neighbour. O(n log n)
/// of the corners of a piece, on task.threads.
///
/// With a `gap` (m, > 0) pieces are shrunk by half of it along their cut edges; contacts do not change. Pieces that are
/// then too thin are reported (VanishedPiece) and omitted with their mass.
///
/// Errors: Cancelled.
Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, const TaskContext& task = {});
Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, double gap, const TaskContext& task = {});

}  // namespace rubble
