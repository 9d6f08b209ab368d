#pragma once

#include "core/asset/Project.h"
#include "core/fracture/Delaunay.h"
#include "core/fracture/Fragment.h"

#include <string>

namespace rubble {

/// All that says how one solid, the whole or a fragment, is broken.
struct Recipe {
    Pattern pattern;
    Shaping shaping;
    std::vector<FragmentEdit> edits;  // those of this place are carried out
    FragmentPath place;               // of the solid; empty: the whole
    Vec2 offset{0.0, 0.0};            // of its frame in the prism's, m
};
/// That of an asset's whole, and that of one of its fragments, which stands at `offset`, by a level.
Recipe recipeOf(const Asset& asset);
Recipe recipeOf(const Asset& asset, const std::string& fragmentId, const Level& level, Vec2 offset);

/// How wide the gaps between its pieces are, m: as wide as the artist and the pattern's joints ask for.
double gapOf(const Recipe& recipe);

/// The stages of breaking a solid as far as they lie in the plane.
struct PlaneBreaking {
    Prism prism;  // validated
    Seeds seeds;  // without those that were dropped for the smallness of their cells
    Delaunay delaunay;
    Partition partition;  // with pieces merged and split
};

/// All stages of breaking one solid.
struct Breaking {
    Prism prism;  // validated
    Seeds seeds;
    Delaunay delaunay;
    Fragments fragments;  // with the partition
};

/// An error with the asset's name before its sentence; a cancellation as it is.
Error ofAsset(const Asset& asset, const Error& error);

/// Prism, seeds, triangulation and partition: its pieces merged and split by hand, then rid of small ones.
///
/// Errors: those of validated(Prism), seedsOf, triangulate; Cancelled.
Result<PlaneBreaking> cutBy(const Recipe& recipe, Prism prism, const TaskContext& task);

/// The same, and the fragments. The same errors.
Result<Breaking> brokenBy(const Recipe& recipe, Prism prism, const TaskContext& task);

/// The pattern with the random seed of each layer mixed with a fragment's id, so that no two fragments break alike.
Pattern patternFor(const std::string& fragmentId, Pattern pattern);

/// The id of a fragment that was broken off by these seeds, below the id of the whole or of the fragment it was a part of:
/// "3/5.17", or "3/5.17.1" where the outline cuts the cell apart (see pieceName); "3/0.0" where there are no seeds.
std::string fragmentId(const std::string& parentId, const Seeds& seeds, const Fragment& fragment);

}  // namespace rubble
