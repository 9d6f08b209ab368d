#include "core/asset/Bake.h"

namespace rubble {

std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset \"" + asset.name + "\": the mesh of ";
    if (auto fault = verifyMesh(wholeMesh(bake, asset), bake.whole.volume)) return owner + "the whole: " + *fault;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment fragment = bake.fragment(k);
        // Not its mass: that may hold what a neighbour was too thin for.
        const double volume = area(fragment.solid.outline()) * fragment.solid.depth();
        if (auto fault = verifyMesh(fragmentMesh(fragment, asset), volume)) {
            return owner + "fragment " + bake.fragmentId(k) + ": " + *fault;
        }
    }
    return std::nullopt;
}

}  // namespace rubble
