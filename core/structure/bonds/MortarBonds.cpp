#include "core/structure/bonds/MortarBonds.h"

#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace rubble {
namespace {

Box3 boxOfHull(const Polytope& hull, double grown) {
    Box3 box;
    for (const Vec3& vertex : hull.vertices) box.include(vertex);
    box.min -= Vec3(grown);
    box.max += Vec3(grown);
    return box;
}

/// A hull of one of several nodes.
struct NodeHull {
    std::uint32_t node = 0;
    const Polytope* hull = nullptr;
};

std::vector<NodeHull> hullsOf(std::span<const MortarNode> nodes) {
    std::vector<NodeHull> hulls;
    for (std::uint32_t node = 0; node < nodes.size(); ++node)
        for (const Polytope& hull : nodes[node].hulls) hulls.push_back({node, &hull});
    return hulls;
}

BoxTree treeOf(std::span<const NodeHull> hulls) {
    std::vector<Box3> boxes;
    boxes.reserve(hulls.size());
    for (const NodeHull& hull : hulls) boxes.push_back(boxOfHull(*hull.hull, 0.0));
    return BoxTree(boxes);
}

/// The contact of two hulls of a pair.
struct HullContact {
    std::uint32_t first = 0;
    std::uint32_t second = kNone;
    std::size_t hulls[2] = {0, 0};
    FaceContact contact;
    auto order() const { return std::tie(first, second, hulls[0], hulls[1]); }
};

Bond bondOfContact(const HullContact& pair, const FaceContact& contact, std::span<const MortarNode> nodes) {
    Bond bond{.first = pair.first,
              .second = pair.second,
              .area = contact.area,
              .centroid = contact.centroid,
              .normal = contact.normal,
              .moments = contact.moments};
    const Vec3 centre = nodes[pair.first].centre;
    // An anchor is at the face: its distance is that of the fragment alone.
    bond.seedDistance = pair.second == kNone ? seedDistanceToFace(bond, centre)
                                             : seedDistanceOf(bond, std::nullopt, {centre, nodes[pair.second].centre});
    return bond;
}

/// The contacts of each pair as one bond.
std::vector<Bond> bondsOfContacts(std::vector<HullContact> contacts, std::span<const MortarNode> nodes,
                                  double leastArea) {
    std::ranges::sort(contacts, [](const HullContact& a, const HullContact& b) { return a.order() < b.order(); });
    std::vector<Bond> bonds;
    std::vector<FaceContact> ofPair;
    for (std::size_t begin = 0, end = 0; begin < contacts.size(); begin = end) {
        ofPair.clear();
        for (; end < contacts.size() && contacts[end].first == contacts[begin].first &&
               contacts[end].second == contacts[begin].second;
             ++end)
            ofPair.push_back(contacts[end].contact);
        const FaceContact sum = *combinedContact(ofPair);
        if (sum.area >= leastArea) bonds.push_back(bondOfContact(contacts[begin], sum, nodes));
    }
    return bonds;
}

}  // namespace

std::vector<Bond> mortarBonds(std::span<const MortarNode> nodes, double tolerance, double leastArea,
                              std::size_t* budget) {
    const double farthest = tolerance + kFaceRounding;
    const std::vector<NodeHull> hulls = hullsOf(nodes);
    const BoxTree tree = treeOf(hulls);
    std::vector<HullContact> contacts;
    std::size_t left = budget != nullptr ? *budget : std::numeric_limits<std::size_t>::max();
    left -= std::min(left, hulls.size());
    for (std::size_t k = 0; k < hulls.size() && left > 0; ++k) {
        const NodeHull& hull = hulls[k];
        tree.visitOverlapping(boxOfHull(*hull.hull, farthest), [&](std::uint32_t j) {
            const NodeHull& other = hulls[j];
            if (other.node <= hull.node || nodes[other.node].body == nodes[hull.node].body || left == 0) return;
            --left;
            if (const auto contact = faceContact(*hull.hull, *other.hull, farthest, 0.0))
                contacts.push_back({hull.node, other.node, {k, j}, *contact});
        });
    }
    if (budget != nullptr) *budget = left;
    return bondsOfContacts(std::move(contacts), nodes, leastArea);
}

std::vector<Bond> anchorBonds(std::span<const MortarNode> nodes, std::span<const Polytope> supports, double tolerance,
                              double leastArea) {
    const double farthest = tolerance + kFaceRounding;
    const std::vector<NodeHull> hulls = hullsOf(nodes);
    const BoxTree tree = treeOf(hulls);
    std::vector<HullContact> contacts;
    for (std::size_t k = 0; k < supports.size(); ++k) {
        tree.visitOverlapping(boxOfHull(supports[k], farthest), [&](std::uint32_t j) {
            if (const auto contact = faceContact(*hulls[j].hull, supports[k], farthest, 0.0))
                contacts.push_back({hulls[j].node, kNone, {j, k}, *contact});
        });
    }
    return bondsOfContacts(std::move(contacts), nodes, leastArea);
}

}  // namespace rubble
