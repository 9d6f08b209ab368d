#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Edit.h"
#include "editor/document/FragmentSelection.h"

namespace rubble {

// Edits of the selected seeds of an asset's pattern. `parent` is the fragment that the pattern fractures; empty: the
// whole asset.

/// The selected cells that come from seeds. Cells of bricks, slices and other cut layers are selected in the same way,
/// but have no seed.
FragmentSelection::Seeds seedsAmong(const BakedPattern& pattern, const FragmentSelection::Seeds& selected);

/// Deletes seeds of an asset.
Edit deleteSeeds(Asset asset, const FragmentPath& parent, const FragmentSelection::Seeds& seeds);

/// Returns moved and deleted seeds to where they were scattered: the given ones, or all of the pattern if `seeds` is
/// empty. The edit is empty if there is none.
Edit restoreSeeds(Asset asset, const FragmentPath& parent, const FragmentSelection::Seeds& seeds);

}  // namespace rubble
