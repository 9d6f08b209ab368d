#pragma once

#include "editor/document/Selection.h"

namespace rubble {

// Hiding fragments of the active asset; `bake` is its last bake. Hiding a fragment hides its child fragments, and a
// fragment whose children are all hidden is hidden.

/// Hides the selected fragments and clears the selection.
void hideSelected(Selection& selection, const Bake& bake);
/// Shows the selected fragments.
void showSelected(Selection& selection, const Bake& bake);
/// Hides all fragments that are not selected; does nothing if none is selected.
void isolateSelected(Selection& selection, const Bake& bake);
/// Shows all fragments.
void showAllFragments(Selection& selection);

}  // namespace rubble
