#include "core/asset/Bake.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kRelative = 1e-9;  // of a volume

}  // namespace

std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset \"" + asset.name + "\": the mesh of ";
    if (auto fault = verifyMesh(wholeMesh(bake, asset), bake.whole.volume)) return owner + "the whole: " + *fault;
    const bool isRough = asset.shaping.roughness.amplitude > 0.0;
    for (const BakedBreaking& breaking : bake.breakings) {
        double sum = 0.0, sumOfMeshes = 0.0;
        for (std::uint32_t k = breaking.first; k < breaking.first + breaking.fragments.count(); ++k) {
            const BakedFragment fragment = bake.fragment(k);
            const Mesh mesh = fragmentMesh(fragment, asset);
            // Not its mass: that may hold what a neighbour was too thin for.
            const double volume = area(fragment.solid.outline()) * fragment.solid.depth();
            if (auto fault = verifyMesh(mesh, isRough ? volumeOf(mesh) : volume)) {
                return owner + "fragment " + bake.fragmentId(k) + ": " + *fault;
            }
            sum += volume;
            sumOfMeshes += volumeOf(mesh);
        }
        // What a rough cut takes from one piece it gives to another, but for gaps.
        if (asset.shaping.gap > 0.0 || std::abs(sumOfMeshes - sum) <= kRelative * sum) continue;
        return owner + "the pieces of " + (breaking.parent == kNone ? "the whole" : bake.fragmentId(breaking.parent)) +
               ": the volumes inside them do not sum to theirs.";
    }
    return std::nullopt;
}

}  // namespace rubble
