#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/FragmentSelection.h"

namespace rubble {

// Selecting cells of a pattern: each is named by its seed, or by the cell of a cut layer where there are no seeds. See
// cellId().

/// All cells, and the seeds without a cell.
FragmentSelection::Seeds allCells(const BakedPattern& pattern);
/// All cells that are not selected.
FragmentSelection::Seeds invertedCells(const BakedPattern& pattern, const FragmentSelection::Seeds& selected);
/// The selected cells and their neighbours: cells that share an edge of at least minimumSharedEdge().
FragmentSelection::Seeds withNeighbourCells(const BakedPattern& pattern, const FragmentSelection::Seeds& selected);

/// Whether each piece of a partition makes a selected fragment. The partition of these seeds fractures the fragment
/// `parent` of an asset (empty: the whole asset). O(n log n); the names of pieces are made in selected cells only.
std::vector<bool> selectedPieces(Id asset, const Partition& partition, const Seeds& seeds,
                                 const FragmentSelection& selection, const FragmentPath& parent);
/// The same for a pattern.
std::vector<bool> selectedPieces(const BakedPattern& pattern, const FragmentSelection& selection);

/// The length (m) from which a shared edge makes two pieces neighbours.
double minimumSharedEdge(const BakedPattern& pattern);

}  // namespace rubble
