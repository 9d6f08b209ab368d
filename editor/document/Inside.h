#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"

#include <optional>

namespace rubble {

// A fragment that is broken again is seen and edited as the whole is: one goes into it.

/// A fragment as what is broken again.
struct FragmentSolid {
    Prism prism;            // in its own frame, which its seeds are in
    Vec2 offset{0.0, 0.0};  // of that frame in the asset's, m
};
/// As it was baked last; where baking failed, as it was before. None where it is not there.
std::optional<FragmentSolid> solidOf(const Bakes& bakes, Id asset, const FragmentPath& fragment);

/// A state of the asset as if a fragment that is broken again were all of it: with that prism, and the pattern that breaks it.
Asset asWhole(Asset asset, const FragmentPath& fragment, Prism prism);

/// The fragment itself where it is there and broken again, else the nearest that it is a piece of; at last the whole. `bake`: the
/// asset's last one; null where that failed, which says nothing about what is there.
FragmentPath nearestBroken(const Asset& asset, const Bake* bake, const FragmentPath& fragment);

/// Goes into a fragment, where nothing is chosen yet.
void goInto(Selection& selection, const FragmentPath& fragment);
/// Goes out as far as to `place`, and chooses what one comes from.
void goOut(Selection& selection, const FragmentPath& place);
/// Goes out of what is not there any more, or not broken any more.
void leaveWhatIsGone(Selection& selection, const Project& project, const Bakes& bakes);

}  // namespace rubble
