#include "core/asset/strength/FragmentThresholds.h"

#include "core/asset/project/FragmentLevels.h"
#include "core/base/math/Roots.h"

#include <algorithm>

namespace rubble {

std::optional<double> ownThreshold(const Asset& asset, const FragmentPath& fragment) {
    const auto found = std::ranges::lower_bound(asset.fragmentThresholds, fragment, {}, &FragmentThreshold::fragment);
    const bool isFound = found != asset.fragmentThresholds.end() && found->fragment == fragment;
    return isFound ? std::optional(found->threshold) : std::nullopt;
}

std::optional<double> fragmentThreshold(const Asset& asset, const FragmentPath& fragment, std::uint32_t level) {
    const Level* own = levelFor(asset, fragment, level);
    if (own == nullptr) return std::nullopt;
    const std::optional<double> alone = ownThreshold(asset, fragment);
    return alone ? alone : own->threshold;
}

double thresholdScaleOf(double volumeFraction) {
    const double root = cubeRoot(volumeFraction);
    return root * root;
}

}  // namespace rubble
