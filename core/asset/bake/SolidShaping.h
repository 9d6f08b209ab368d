#pragma once

#include "core/asset/project/Shaping.h"
#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/solid/SolidPartition.h"

#include <vector>

namespace rubble {

/// Applies the edits whose parent is `parent` to the fragments of a mesh, in order: what editedPieces() is for an
/// outline. Fragments are split along the plane through the line along z. `offset`, m, is that of the mesh's frame in
/// the asset's. Reports LostPiece where a fragment is missing, is not connected to the one it is merged into, or is not
/// intersected by its line.
///
/// Errors: Cancelled.
Result<SolidPartition> editedFragments(SolidPartition partition, const Seeds& seeds,
                                       const std::vector<FragmentEdit>& edits, const FragmentPath& parent, Vec2 offset,
                                       std::vector<Diagnostic>& diagnostics, const TaskContext& task = {});

/// The minimum volume of fragments, m³, for `count` fragments with a total of `volume`. An area is none of a mesh's.
double minFragmentVolume(const SmallPieces& small, double volume, std::uint32_t count);

/// Merges fragments below the limit, as withoutSmallPieces() does, and reports each (MergedPiece).
SolidPartition withoutSmallFragments(SolidPartition partition, const SmallPieces& small, const Seeds& seeds,
                                     std::vector<Diagnostic>& diagnostics);

/// The seeds to be dropped next for SmallPieceRule::DropSeeds, as of an outline: see seedsToDrop(Partition).
std::vector<std::uint32_t> seedsToDrop(const SolidPartition& partition, const SmallPieces& small);

}  // namespace rubble
