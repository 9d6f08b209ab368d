#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"

#include <optional>

namespace rubble {

// A fractured fragment can be entered: the canvas shows and edits its pattern as if it were the whole asset.

/// The solid of a fragment.
struct FragmentSolid {
    Prism prism;            // in the fragment's frame, like its seeds
    Vec2 offset{0.0, 0.0};  // of that frame in the asset's, m
};
/// The solid in the last bake; if that failed, in the last pattern. None if the fragment does not exist, or is one of a
/// mesh.
std::optional<FragmentSolid> fragmentSolid(const Bakes& bakes, Id asset, const FragmentPath& fragment);

/// A fractured fragment as an asset of its own: `asset` with the fragment's prism and pattern in place of its own.
Asset fragmentAsAsset(Asset asset, const FragmentPath& fragment, Prism prism);

/// The fragment itself if it exists and is fractured, otherwise its nearest such ancestor; the empty path for the whole
/// asset. `bake` is the asset's last bake, or null if that failed; then all fragments that have a level are assumed to
/// exist.
FragmentPath nearestFractured(const Asset& asset, const Bake* bake, const FragmentPath& fragment);

/// Enters a fragment and clears the selection.
void enterFragment(Selection& selection, const FragmentPath& fragment);
/// Exits to an ancestor of the entered fragment (empty: the whole asset) and selects the fragment that was left.
void exitToFragment(Selection& selection, const FragmentPath& ancestor);
/// Exits fragments that no longer exist or are no longer fractured.
void exitRemovedFragments(Selection& selection, const Project& project, const Bakes& bakes);

}  // namespace rubble
