#pragma once

#include "core/asset/texture/AssetAtlas.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/WallWithOpenings.h"

#include <memory>
#include <vector>

namespace rubble::test {

/// An asset with its meshes: the whole, then the fragments.
struct TexturedAsset {
    std::shared_ptr<const Asset> asset;
    std::vector<Mesh> meshes;
    std::vector<Vec3> offsets;

    Result<TextureAtlas> atlas(int side, TexturedSides sides = {}) const {
        TextureAtlasBuilder builder(sides);
        for (std::size_t k = 0; k < meshes.size(); ++k) builder.add(meshes[k], offsets[k]);
        return std::move(builder).atlas(side);
    }
};

inline TexturedAsset texturedAsset(Asset source) {
    TexturedAsset made{std::make_shared<const Asset>(std::move(source)), {}, {}};
    const Bake baked = bake(*made.asset).value();
    const FragmentMesher mesher(*made.asset);
    const RoughCuts cuts(baked, *made.asset);
    made.meshes.push_back(mesher.wholeMesh(baked));
    made.offsets.push_back(baked.whole.centre);
    for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
        made.meshes.push_back(mesher.fragmentMesh(baked.fragment(k), cuts.cornersOf(k)));
        made.offsets.push_back(baked.fragment(k).solid.offset());
    }
    return made;
}

/// A wall with openings and two levels, a box with rough cuts and gaps, a cut torus, and a cut cube.
inline std::vector<Asset> texturedSamples() {
    Asset rough = boxAsset(2, 3, UniformScatter{.count = 12});
    rough.shaping.roughness = {.amplitude = 0.02, .frequency = 8.0};
    rough.shaping.gap = 0.004;
    return {wallWithOpenings().assets[0], rough, meshAsset(torus(24, 12), 9), meshAsset(mengerSponge(1), 6)};
}

}  // namespace rubble::test
