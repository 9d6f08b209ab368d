#pragma once

#include "core/asset/project/FragmentPath.h"
#include "core/asset/project/Project.h"
#include "core/base/Hash.h"
#include "core/base/TaskContext.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/solid/SolidHulls.h"

#include <string>
#include <vector>

namespace rubble {

/// The fragments of the whole, or the children of one fragment.
struct BakedFracture {
    std::uint32_t parent = kNone;  // number of the fractured fragment; kNone: the whole
    std::uint32_t level = 0;       // of the fragments; 0: those of the whole
    std::uint32_t first = 0;       // number of its first fragment in the bake
    Seeds seeds;
    Fragments fragments;  // offsets in the asset's frame
};

/// One fragment with its place in the tree of fragments. A view, as `solid` is.
struct BakedFragment {
    std::uint32_t parent = kNone;  // kNone: the whole
    std::uint32_t level = 0;
    std::uint32_t firstChild = 0;  // children are consecutive
    std::uint32_t childCount = 0;
    std::uint32_t firstSibling = 0;  // number of the fragment with index 0 in bonds and edgeNeighbours() of `solid`
    Fragment solid;
};

/// Everything computed from an asset: never saved, shared as const. Fragments are numbered level by level, within a
/// level by parent, then in seed order.
struct Bake {
    Id asset = 0;
    ContentHash input;                     // bakeInputHash() of the asset
    MassProperties whole;                  // of the asset, at density 1
    std::vector<Polytope> wholeHulls;      // in the frame of the whole's centre of mass
    std::vector<BakedFracture> fractures;  // of the whole, then ascending parent
    std::vector<Diagnostic> diagnostics;   // level by level

    std::uint32_t fragmentCount() const;
    /// O(log fractures), as are fractureOf() and fractureContaining().
    BakedFragment fragment(std::uint32_t number) const;
    /// The id of a fragment: "asset/seed", ".k" for a part of a cut-apart cell, one more "/…" per level:
    /// "3/5.17.1/9.2". O(log fractures + log pieces) for each level.
    std::string fragmentId(std::uint32_t number) const;
    /// Its id without the asset: "5.17.1/9.2". O(log fractures + log pieces) for each level.
    FragmentPath fragmentPath(std::uint32_t number) const { return pathOfId(fragmentId(number)); }
    /// The fracture of a fragment (kNone: of the whole); null if it is not fractured.
    const BakedFracture* fractureOf(std::uint32_t parent) const;
    /// The index of the fracture that a fragment comes from.
    std::uint32_t fractureContaining(std::uint32_t number) const;
};

/// What a bake may make coarser, or take from another, where it is needed at once.
struct BakeSettings {
    HullLimits hulls;             // of the fragments of meshes
    const Bake* whole = nullptr;  // of an asset of the same shape: mass and hulls of the whole are taken from it
};

/// Carries out an asset's recipe: seeds, partition and fragments, level by level.
///
/// Errors, each with the asset's name: BadInput for a shape out of range (shapeRangeFault()); those of
/// validated(Prism), seedsOf() and triangulate(); Limit if the bake would be too large (sizeFault()), before it starts
/// or before a level; Cancelled.
Result<Bake> bake(const Asset& asset, const TaskContext& task = {}, const BakeSettings& settings = {});

}  // namespace rubble
