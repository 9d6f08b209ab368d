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

/// One fragment with its place in the asset's tree of levels.
struct BakedFragment {
    std::string id;                // "asset/seed", ".k" for a cut-apart cell, one more "/..." a level: "3/5.17.1/9.2"
    std::uint32_t parent = kNone;  // index of the fragment it is a piece of; kNone: of the whole
    std::uint32_t level = 0;       // 0: a piece of the whole
    std::uint32_t firstChild = 0;  // children are consecutive; childCount 0 where it is not broken again
    std::uint32_t childCount = 0;
    Fragment solid;  // bonds and `across` are indices among its siblings; offset in the prism's frame
};

/// All that follows from an asset: derived, never saved, shared as const.
struct Bake {
    Id asset = 0;
    ContentHash input;  // of everything it was made from
    Seeds seeds;
    Partition partition;                   // of the first level
    MassProperties whole;                  // of the prism, at density 1
    std::vector<Polytope> wholeHulls;      // in the frame of the whole's centre of mass
    std::vector<BakedFragment> fragments;  // level 0 in seed order, then level 1, ...
    std::vector<Report> reports;
};

/// Carries out an asset's recipe: seeds, partition, fragments, level by level.
///
/// Errors: those of validated(Prism), seedsOf, triangulate, each with the asset's name; Cancelled.
Result<Bake> bake(const Asset& asset, const TaskContext& task = {});

/// A hash of all that bake() depends on: the same asset gives the same, whatever its name.
ContentHash bakeInputHash(const Asset& asset);

/// Checks every stage of a bake: see core/fracture/Verify.h.
std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset);

/// The render mesh of a fragment in its own frame, or of the whole about its centre of mass.
Mesh fragmentMesh(const BakedFragment& fragment, const Asset& asset);
Mesh wholeMesh(const Bake& bake, const Asset& asset);

/// Checks these meshes, the whole's and every fragment's: see verifyMesh().
std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset);

}  // namespace rubble
