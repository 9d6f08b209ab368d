#include "core/asset/checks/VerifyMeshes.h"

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/base/MessageText.h"

#include <cmath>
#include <vector>

namespace rubble {
namespace {

constexpr double kRelative = 1e-9;  // of a volume

double shapeVolumeOf(const Fragment& solid) {
    const std::optional<ExtrudedFragment> extruded = solid.extruded();
    return extruded ? area(extruded->outline()) * extruded->depth() : solid.volume();
}

}  // namespace

std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset " + quotedName(asset.name) + ": the mesh of ";
    const FragmentMesher mesher(asset);
    if (auto fault = verifyMesh(mesher.wholeMesh(bake), bake.whole.volume)) return owner + "the whole: " + *fault;
    const double cutFrom = asset.mesh() != nullptr ? asset.mesh()->bounds.diagonal() : 0.0;
    const bool isRough = asset.shaping.roughness.amplitude > 0.0;
    const RoughCuts cuts(bake, asset);
    std::vector<double> gained;  // m³ of each fragment, by rough cuts
    for (const BakedFracture& fracture : bake.fractures) {
        double sum = 0.0, sumGained = 0.0;
        for (std::uint32_t k = fracture.first; k < fracture.first + fracture.fragments.count(); ++k) {
            const BakedFragment fragment = bake.fragment(k);
            const Mesh mesh = mesher.fragmentMesh(fragment, cuts.cornersOf(k));
            // Not its mass, which may include that of a thin neighbour.
            const double volume = shapeVolumeOf(fragment.solid);
            if (auto fault = verifyMesh(mesh, isRough ? volumeOf(mesh) : volume, cutFrom)) {
                return owner + "fragment " + bake.fragmentId(k) + ": " + *fault;
            }
            gained.push_back(volumeOf(mesh) - volume);
            sum += volume;
            sumGained += gained.back();
        }
        // Without gaps a rough cut moves volume between pieces: together they gain as much as their parent did.
        const bool hasGap = fracture.fragments.gap > 0.0;
        const double expected = fracture.parent == kNone ? 0.0 : gained[fracture.parent];
        if (hasGap || std::abs(sumGained - expected) <= kRelative * sum) continue;
        return owner + "the pieces of " + (fracture.parent == kNone ? "the whole" : bake.fragmentId(fracture.parent)) +
               ": the volumes inside them do not sum to theirs.";
    }
    return std::nullopt;
}

}  // namespace rubble
