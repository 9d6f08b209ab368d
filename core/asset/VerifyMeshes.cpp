#include "core/asset/RoughCuts.h"

#include <cmath>
#include <vector>

namespace rubble {
namespace {

constexpr double kRelative = 1e-9;  // of a volume

}  // namespace

std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset \"" + asset.name + "\": the mesh of ";
    if (auto fault = verifyMesh(wholeMesh(bake, asset), bake.whole.volume)) return owner + "the whole: " + *fault;
    const bool isRough = asset.shaping.roughness.amplitude > 0.0;
    const RoughCuts cuts(bake, asset);
    std::vector<double> gained;  // m^3 of each fragment, by rough cuts
    for (const BakedBreaking& breaking : bake.breakings) {
        double sum = 0.0, sumGained = 0.0;
        for (std::uint32_t k = breaking.first; k < breaking.first + breaking.fragments.count(); ++k) {
            const BakedFragment fragment = bake.fragment(k);
            const Mesh mesh = fragmentMesh(fragment, asset, cuts.cornersOf(k));
            // Not its mass: that may hold what a neighbour was too thin for.
            const double volume = area(fragment.solid.outline()) * fragment.solid.depth();
            if (auto fault = verifyMesh(mesh, isRough ? volumeOf(mesh) : volume)) {
                return owner + "fragment " + bake.fragmentId(k) + ": " + *fault;
            }
            gained.push_back(volumeOf(mesh) - volume);
            sum += volume;
            sumGained += gained.back();
        }
        // What a rough cut takes from one piece it gives to another, but for gaps; together they gain what the broken one did.
        const bool hasGap = !breaking.fragments.shrunk.ringsOfPiece.empty();
        const double expected = breaking.parent == kNone ? 0.0 : gained[breaking.parent];
        if (hasGap || std::abs(sumGained - expected) <= kRelative * sum) continue;
        return owner + "the pieces of " + (breaking.parent == kNone ? "the whole" : bake.fragmentId(breaking.parent)) +
               ": the volumes inside them do not sum to theirs.";
    }
    return std::nullopt;
}

}  // namespace rubble
