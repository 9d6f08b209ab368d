#pragma once

#include "core/asset/project/Shaping.h"
#include "core/base/Diagnostic.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/solid/SolidPartition.h"

#include <vector>

namespace rubble {

/// Applies the merges whose parent is `parent` to the fragments of a mesh. Reports LostPiece where a fragment is
/// missing or not connected to the one it is merged into.
SolidPartition editedFragments(SolidPartition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                               const FragmentPath& parent, std::vector<Diagnostic>& diagnostics);

/// The minimum volume of fragments, m³, for `count` fragments with a total of `volume`. An area is none of a mesh's.
double minFragmentVolume(const SmallPieces& small, double volume, std::uint32_t count);

/// Merges fragments below the limit, as withoutSmallPieces() does, and reports each (MergedPiece).
SolidPartition withoutSmallFragments(SolidPartition partition, const SmallPieces& small, const Seeds& seeds,
                                     std::vector<Diagnostic>& diagnostics);

/// The seeds to be dropped next for SmallPieceRule::DropSeeds, as of an outline: see seedsToDrop(Partition).
std::vector<std::uint32_t> seedsToDrop(const SolidPartition& partition, const SmallPieces& small);

}  // namespace rubble
