#include "core/structure/clusters/ClusterColours.h"

#include "core/asset/project/FragmentColours.h"
#include "core/structure/clusters/ClusterLevels.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kMinLightness = 0.62, kMaxLightness = 0.88, kLightness = 0.76;
constexpr double kGoldenRatio = 0.6180339887498949;  // places of a series are far from those before

double lightnessOf(std::uint32_t cluster) {
    const double place = kGoldenRatio * cluster;
    return kMinLightness + (kMaxLightness - kMinLightness) * (place - std::floor(place));
}

}  // namespace

std::vector<Colour> clusterColours(const Asset& asset, const Bake& bake, std::uint32_t fracture) {
    const std::vector<std::vector<std::uint32_t>> levels = clustersOfFragments(asset, bake, fracture);
    std::vector<Colour> colours(bake.fractures[fracture].fragments.count(), kUnclusteredColour);
    for (std::uint32_t k = 0; k < colours.size(); ++k) {
        std::uint32_t coarsest = kNone, deepest = kNone;
        for (const std::vector<std::uint32_t>& level : levels) {
            if (level[k] == kNone) continue;
            if (coarsest == kNone) coarsest = level[k];
            deepest = level[k];
        }
        if (coarsest == kNone) continue;
        colours[k] = seriesColour(coarsest, deepest == coarsest ? kLightness : lightnessOf(deepest));
    }
    return colours;
}

}  // namespace rubble
