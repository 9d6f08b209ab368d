#pragma once

#include "core/asset/Project.h"
#include "core/base/Hash.h"
#include "core/fracture/Fragment.h"
#include "core/fracture/Pattern.h"
#include "core/geometry/Mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace rubble {

/// How a fragment is broken again: in its own way, or as its level says. Null where it stays whole whatever its size.
const Level* levelFor(const Asset& asset, const FragmentPath& fragment, std::uint32_t level);

/// What the whole, or one fragment, was broken into.
struct BakedBreaking {
    std::uint32_t parent = kNone;  // the fragment that was broken; kNone: the whole
    std::uint32_t level = 0;       // 0: the whole
    std::uint32_t first = 0;       // number of its first fragment in the bake
    Seeds seeds;
    Fragments fragments;  // offsets in the asset's frame
};

/// One fragment with its place in the asset's tree of levels: a view, as `solid` is.
struct BakedFragment {
    std::uint32_t parent = kNone;  // the fragment it is a piece of; kNone: of the whole
    std::uint32_t level = 0;       // 0: a piece of the whole
    std::uint32_t firstChild = 0;  // children are consecutive; childCount 0 where it is not broken again
    std::uint32_t childCount = 0;
    std::uint32_t firstSibling = 0;  // the fragment that bonds and `across` of `solid` call 0
    Fragment solid;
};

/// All that follows from an asset: derived, never saved, shared as const. Fragments are numbered through: level 0 in seed
/// order, then level 1, ...
struct Bake {
    Id asset = 0;
    ContentHash input;                     // of everything it was made from
    MassProperties whole;                  // of the prism, at density 1
    std::vector<Polytope> wholeHulls;      // in the frame of the whole's centre of mass
    std::vector<BakedBreaking> breakings;  // of the whole, then by parent
    std::vector<Report> reports;

    std::uint32_t fragmentCount() const;
    /// O(log of the number of breakings), as the others are, too.
    BakedFragment fragment(std::uint32_t number) const;
    /// "asset/seed", ".k" for a cut-apart cell, one more "/..." a level: "3/5.17.1/9.2".
    std::string fragmentId(std::uint32_t number) const;
    /// What a fragment (kNone: the whole) was broken into; null where it was not.
    const BakedBreaking* breakingOf(std::uint32_t parent) const;
};

/// Carries out an asset's recipe: seeds, partition, fragments, level by level.
///
/// Errors: those of validated(Prism), seedsOf, triangulate, each with the asset's name; Cancelled.
Result<Bake> bake(const Asset& asset, const TaskContext& task = {});

/// A hash of all that bake() depends on: the same asset gives the same, whatever its name.
ContentHash bakeInputHash(const Asset& asset);

/// Checks every stage of a bake: see core/fracture/Verify.h.
std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset);

/// Corners that are put into the edges of a fragment, in its frame: one list an edge, ring after ring as Fragment::across() has them.
/// No lists: all edges stay straight.
using EdgeCorners = std::vector<std::vector<Vec2>>;

/// The render mesh of a fragment in its own frame, its cuts rough by what RoughCuts tells, or of the whole about its centre of mass.
Mesh fragmentMesh(const BakedFragment& fragment, const Asset& asset, const EdgeCorners& rough = {});
Mesh wholeMesh(const Bake& bake, const Asset& asset);

/// Checks these meshes, the whole's and every fragment's: see verifyMesh().
std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset);

}  // namespace rubble
