#pragma once

#include "core/asset/Project.h"
#include "core/fracture/Delaunay.h"
#include "core/fracture/Fragment.h"

#include <string>

namespace rubble {

/// All stages of breaking one solid by one pattern.
struct Breaking {
    Prism prism;  // validated
    Seeds seeds;
    Delaunay delaunay;
    Fragments fragments;  // with the partition
};

/// An error with the asset's name before its sentence; a cancellation as it is.
Error ofAsset(const Asset& asset, const Error& error);

/// Prism, seeds, triangulation, partition and fragments.
///
/// Errors: those of validated(Prism), seedsOf, triangulate; Cancelled.
Result<Breaking> brokenBy(const Pattern& pattern, Prism prism, const TaskContext& task);

/// The pattern with the random seed of each layer mixed with a fragment's id, so that no two fragments break alike.
Pattern patternFor(const std::string& fragmentId, Pattern pattern);

/// The id of a fragment that was broken off by these seeds, below the id of the whole or of the fragment it was a part of:
/// "3/5.17", or "3/5.17.1" where the outline cuts the cell apart; "3/0.0" where there are no seeds.
std::string fragmentId(const std::string& parentId, const Seeds& seeds, const Fragment& fragment);

}  // namespace rubble
