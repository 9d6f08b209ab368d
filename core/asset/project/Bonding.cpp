#include "core/asset/project/Bonding.h"

#include <algorithm>

namespace rubble {

bool StrengthImage::operator==(const StrengthImage& other) const {
    const bool isSame = image == other.image || (image && other.image && *image == *other.image);
    return isSame && darkest == other.darkest && brightest == other.brightest;
}

void sortClusters(std::vector<FragmentCluster>& clusters) {
    std::erase_if(clusters, [](const FragmentCluster& cluster) { return cluster.fragments.empty(); });
    for (FragmentCluster& cluster : clusters) std::ranges::sort(cluster.fragments);
    std::ranges::sort(clusters);
}

}  // namespace rubble
