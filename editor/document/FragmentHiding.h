#pragma once

#include "editor/document/Selection.h"

namespace rubble {

/// What is done to the chosen fragments of the asset at hand so that pictures leave some out. `bake`: the asset's last one.
/// A fragment is hidden with its pieces, and where all of its pieces are.

/// Hides what is chosen, and lets go of it.
void hideChosen(Selection& selection, const Bake& bake);
/// Shows what is chosen again.
void showChosen(Selection& selection, const Bake& bake);
/// Hides all but what is chosen; nothing where nothing is.
void isolateChosen(Selection& selection, const Bake& bake);
/// Shows everything again.
void showAllFragments(Selection& selection);

}  // namespace rubble
