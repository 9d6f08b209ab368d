#pragma once

#include "core/asset/bake/Bake.h"
#include "core/base/Hash.h"
#include "core/base/TaskContext.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/io/exchange/Pack.h"
#include "core/structure/bonds/Bond.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// What a pack holds beside its bodies.
struct PackSettings {
    double inset = kDefaultInset;  // m, >= 0: of collision hulls, see insetHull()
    DamageRule rule = DamageRule::Impact;
    std::optional<Debris> debris;  // as the project has it
    bool operator==(const PackSettings&) const = default;
};

/// What a pack is made from. Borrowed.
struct PackInput {
    const Bake& bake;
    const Asset& asset;  // in the variant that was baked
    AssetMaterials material;
    PackNames names;
    PackSettings settings;
    Quat orientation{1.0, 0.0, 0.0, 0.0};  // in which it is placed first: baked finishes follow it
};

/// The names of an asset that is exported alone.
PackNames packNames(const Asset& asset);

/// Returns a name of meshName() with '_' for '-' and '.' as well.
std::string identifierOf(std::string name);

/// Returns the name of a fragment in packs and meshes: the folder's name, "_f", and the fragment's path with '_' for
/// '.', "__" for '/' and 'x' for '+': "wall_f3_2__4_1". The whole is "wall_whole". Letters, digits and '_' only, and
/// without an ending that an importer acts upon; unique in the pack.
std::string fragmentBodyName(const PackNames& names, std::string_view fragmentId);
std::string wholeBodyName(const PackNames& names);

/// The materials in the meshes of an asset, that of the inside last.
std::vector<PackSurface> packSurfaces(const Asset& asset, const AssetMaterials& material);

/// Hashes of the inputs of a pack, without baking; equal packs have equal hashes. `physics` is of all but meshes,
/// surfaces and names.
struct PackHashes {
    ContentHash all, physics;
};
PackHashes packHashes(const Asset& asset, const AssetMaterials& material, const PackNames& names,
                      const PackSettings& settings, std::span<const PackMeshFile> meshes);

/// Makes the parts of a pack one by one, so that a large one is never in memory at once. May be used by several threads
/// at once; the results do not depend on their number.
class PackBuilder {
public:
    /// Finds the contacts of all fragments, with task.threads threads.
    explicit PackBuilder(const PackInput& input, const TaskContext& task = {});

    const PackInput& input() const { return m_input; }
    /// The pack without its bodies and bonds.
    Pack header(std::span<const PackMeshFile> meshes) const;
    PackBody whole() const;
    std::uint32_t fragmentCount() const { return m_input.bake.fragmentCount(); }
    PackBody fragment(std::uint32_t index) const;
    /// Nothing if the asset breaks whole.
    std::optional<PackBonding> bonding() const;

private:
    PackBody body(const MassProperties& mass, std::uint32_t index, const std::vector<Polytope>& hulls) const;
    PackFracture fracture(std::uint32_t index) const;

    PackInput m_input;
    double m_threshold;                      // N·s, of the whole
    std::vector<std::vector<Bond>> m_bonds;  // of each fracture
};

/// All of a pack.
Pack packOf(const PackInput& input, std::span<const PackMeshFile> meshes, const TaskContext& task = {});

}  // namespace rubble
