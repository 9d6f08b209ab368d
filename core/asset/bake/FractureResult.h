#pragma once

#include "core/asset/project/Project.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/solid/SolidHulls.h"

#include <string>

namespace rubble {

/// Everything that determines how one solid, the whole or a fragment, is fractured.
struct Recipe {
    Pattern pattern;
    Shaping shaping;
    std::vector<FragmentEdit> edits;  // those with another parent are ignored
    FragmentPath place;               // of the solid; empty: the whole
    Vec3 offset{0.0};                 // m, of its frame in the asset's
    HullLimits hulls;                 // of the fragments of a mesh
};
/// The recipe of an asset's whole.
Recipe recipeOf(const Asset& asset);
/// The recipe of one of its fragments, located at `offset`, for a level.
Recipe recipeOf(const Asset& asset, const std::string& fragmentId, const Level& level, Vec3 offset);

/// The width of the gaps between pieces, m: the larger of the asset's gap and the pattern's joints.
double gapOf(const Recipe& recipe);

/// The stages of fracturing a solid that lie in the plane.
struct PlanarFracture {
    Prism prism;  // validated
    Seeds seeds;  // without those dropped because of their small cells
    Delaunay delaunay;
    Partition partition;  // with merged and split pieces
};

/// All stages of fracturing one solid.
struct FractureResult {
    Prism prism;  // validated; empty for a mesh
    Seeds seeds;
    Delaunay delaunay;    // empty for a mesh
    Fragments fragments;  // with the partition
};

/// Prefixes the message of an error with the asset's name, except for Cancelled.
Error ofAsset(const Asset& asset, const Error& error);

/// Prism, seeds, triangulation and partition: pieces are merged and split by hand, then small pieces are removed.
///
/// Errors: those of validated(Prism), seedsOf() and triangulate(); Limit if it would be too large (sizeFault());
/// Cancelled.
Result<PlanarFracture> planarFracture(const Recipe& recipe, Prism prism, const TaskContext& task);

/// All stages, fragments included. The caller has checked the size: a bake counts its fractures together.
///
/// Errors: those of planarFracture() but Limit.
Result<FractureResult> fractureResult(const Recipe& recipe, Prism prism, const TaskContext& task);

/// All stages of a closed mesh: seeds in space, fragments merged and split by hand, then small ones removed, then a gap
/// taken off.
///
/// Errors: those of seedsOf() and solidFragments(); Cancelled.
Result<FractureResult> fractureResult(const Recipe& recipe, const TriangleMesh& mesh, const TaskContext& task);

/// All stages of an asset's shape, or of one of its fragments.
Result<FractureResult> fractureResult(const Recipe& recipe, const Asset& asset, const TaskContext& task);
Result<FractureResult> fractureResult(const Recipe& recipe, const Fragment& fragment, const TaskContext& task);

/// A fragment of a mesh, less the gap, in its own frame, m.
TriangleMesh meshInOwnFrame(const Fragment& fragment);

/// The pattern with the random seed of each layer mixed with a fragment's id, so that no two fragments fracture alike.
Pattern patternFor(const std::string& fragmentId, Pattern pattern);

/// The id of a fragment, given that of its parent: "3/5.17", or "3/5.17.1" if the outline cuts the cell apart (see
/// pieceName()); "3/0.0" without seeds.
std::string fragmentId(const std::string& parentId, const Seeds& seeds, const Fragment& fragment);

}  // namespace rubble
