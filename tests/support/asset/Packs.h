#pragma once

#include "core/io/pack/PackFile.h"
#include "tests/support/asset/Bonds.h"
#include "tests/support/asset/Projects.h"

namespace rubble {

inline Material heavyBrick() { return {.id = 1, .name = "brick", .density = 1800.0}; }

inline const std::vector<PackMeshFile>& packMeshes() {
    static const std::vector<PackMeshFile> files{
        {.name = "box.obj"}, {.name = "box0.obj", .bodies = PackMeshBodies::Fragment, .fragment = 0}};
    return files;
}

/// A square ring with two levels: cells cut apart, bodies of several hulls, fragments of fragments.
inline Asset twoLevelRing() {
    Asset asset = boxAsset(3, 4, UniformScatter{.count = 5});
    asset.prism().outline = squareRing();
    asset.levels = {{.pattern = {{{.id = 5, .randomSeed = 2, .parameters = UniformScatter{.count = 3}}}}}};
    return asset;
}

/// The same, breaking bonded: with anchored fragments, bonds that never break, and weaker fragments of fragments.
inline Asset bondedRing() {
    Asset asset = twoLevelRing();
    asset.breakAs = BreakAs::Bonded;
    asset.bonding = everyBonding("4");
    asset.levels[0].bondStrength = 0.5;
    return asset;
}

/// The pack of an asset made of a material, with these meshes.
inline std::string packOf(const Asset& asset, const Material& material, const PackSettings& settings,
                          PackTopology topology = PackTopology::Full, int threads = 1) {
    const Result<Bake> baked = bake(asset);
    TaskContext task;
    task.threads = threads;
    const PackInput input{*baked, asset, material, packNames(asset), settings};
    return packJson(PackBuilder(input, task), packMeshes(), topology, task);
}

/// The pack of an asset made of heavy brick, with these meshes.
inline std::string packOf(const Asset& asset, int threads = 1) {
    return packOf(asset, heavyBrick(), {}, PackTopology::Full, threads);
}

/// Its hashes.
inline PackHashes hashesOf(const Asset& asset, const Material& material = heavyBrick(),
                           const std::vector<PackMeshFile>& meshes = packMeshes()) {
    return packHashes(asset, material, packNames(asset), {}, meshes);
}

}  // namespace rubble
