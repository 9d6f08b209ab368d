#include "core/asset/texture/AssetAtlas.h"

namespace rubble {

Result<TextureAtlas> assetAtlas(const Bake& bake, const FragmentMesher& mesher, const RoughCuts& cuts,
                                TexturedSides sides, int side, const TaskContext& task) {
    TextureAtlasBuilder builder(sides);
    builder.add(mesher.wholeMesh(bake), bake.whole.centre);
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const BakedFragment fragment = bake.fragment(k);
        builder.add(mesher.fragmentMesh(fragment, cuts.cornersOf(k)), fragment.solid.offset());
    }
    return std::move(builder).atlas(side);
}

}  // namespace rubble
