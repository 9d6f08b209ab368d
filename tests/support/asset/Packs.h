#pragma once

#include "core/io/pack/PackFile.h"
#include "tests/support/asset/Bonds.h"
#include "tests/support/asset/Projects.h"

namespace rubble {

inline Material heavyBrick() { return {.id = 1, .name = "brick", .density = 1800.0}; }

inline const std::vector<PackMeshFile>& packMeshes() {
    static const std::vector<PackMeshFile> files{{.name = "box.obj"}, {"box0.obj", PackMeshBodies::Fragment, 0, {}}};
    return files;
}

/// A square ring with two levels: cells cut apart, bodies of several hulls, fragments of fragments.
inline Asset twoLevelRing() {
    Asset asset = boxAsset(3, 4, UniformScatter{.count = 5});
    asset.prism.outline = squareRing();
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

/// The pack of an asset made of heavy brick, with these meshes.
inline std::string packOf(const Asset& asset, int threads = 1) {
    const Result<Bake> baked = bake(asset);
    TaskContext task;
    task.threads = threads;
    return packJson(*baked, asset, heavyBrick(), packMeshes(), task);
}

}  // namespace rubble
