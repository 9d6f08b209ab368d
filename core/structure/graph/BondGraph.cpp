#include "core/structure/graph/BondGraph.h"

#include "core/base/Assert.h"

namespace rubble {
namespace {

BoxTree centroidTree(std::span<const Bond> bonds) {
    std::vector<Box3> boxes;
    boxes.reserve(bonds.size());
    for (const Bond& bond : bonds) boxes.push_back({bond.centroid, bond.centroid});
    return BoxTree(boxes);
}

}  // namespace

BondGraph bondGraph(std::vector<Vec3> centres, std::vector<Bond> bonds) {
    std::vector<std::uint32_t> firstLink(centres.size() + 1, 0);
    for (const Bond& bond : bonds) {
        RUBBLE_ASSERT(bond.first < centres.size());
        RUBBLE_ASSERT(bond.second == kNone || (bond.second < centres.size() && bond.second != bond.first));
        ++firstLink[bond.first + 1];
        if (bond.second != kNone) ++firstLink[bond.second + 1];
    }
    for (std::size_t node = 1; node < firstLink.size(); ++node) firstLink[node] += firstLink[node - 1];
    std::vector<BondLink> links(firstLink.back());
    std::vector<std::uint32_t> next(firstLink.begin(), firstLink.end() - 1);
    for (std::uint32_t k = 0; k < bonds.size(); ++k) {
        const Bond& bond = bonds[k];
        links[next[bond.first]++] = {bond.second, k};
        if (bond.second != kNone) links[next[bond.second]++] = {bond.first, k};
    }
    BoxTree tree = centroidTree(bonds);
    return {std::move(centres), std::move(bonds), std::move(firstLink), std::move(links), std::move(tree)};
}

}  // namespace rubble
