#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/FragmentChoice.h"

namespace rubble {

// Choosing by cells in the plane: each by its seed, or by the cell of a cut layer where there are no seeds. See cellId().

/// All cells, and the seeds that have none.
FragmentChoice::Seeds allCells(const BakedPattern& pattern);
/// Those that are not chosen.
FragmentChoice::Seeds otherCells(const BakedPattern& pattern, const FragmentChoice::Seeds& chosen);
/// The chosen cells and those that touch them along an edge that can be seen.
FragmentChoice::Seeds withNeighbourCells(const BakedPattern& pattern, const FragmentChoice::Seeds& chosen);

/// From where on an edge that pieces share can be seen, m.
double leastSharedEdge(const BakedPattern& pattern);

}  // namespace rubble
