#include "core/io/pack/VerifyPackBonding.h"

#include "core/base/Hash.h"
#include "core/base/MessageText.h"
#include "core/geometry/search/Box3.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

using BondErrorText = std::optional<std::string>;

constexpr double kUnitTolerance = 1e-9;   // of the length of a normal
constexpr double kPlaceTolerance = 1e-6;  // of the coordinates of a centroid, and the size of the whole

std::string bodyText(std::uint32_t fragment) {
    return fragment == kNone ? "the whole" : "fragment " + std::to_string(fragment);
}

/// The bounding box of the whole, m, with a margin for rounding and gaps.
Box3 boxOfWhole(const Pack& pack) {
    Box3 box;
    for (const PackHull& hull : pack.whole.hulls) {
        for (const Vec3& vertex : hull.polytope.vertices) box.include(vertex + pack.whole.offset);
    }
    const Vec3 margin{kPlaceTolerance * (glm::length(box.max - box.min) + glm::length(pack.whole.offset)) + pack.gap +
                      pack.inset};
    return {box.min - margin, box.max + margin};
}

bool isInside(const Box3& box, Vec3 point) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(point[axis] >= box.min[axis] && point[axis] <= box.max[axis])) return false;
    }
    return true;
}

/// The error of a bond of the fragments of a body, to follow "its bond".
BondErrorText verifyBond(const Pack& pack, std::uint32_t parent, const PackBond& bond, const Box3& box) {
    const auto [first, second] = bond.fragments;
    if (first >= pack.fragments.size() || second >= pack.fragments.size()) return "refers to a missing fragment";
    if (first >= second) return "is not between two fragments in ascending order";
    if (pack.fragments[first].parent != parent || pack.fragments[second].parent != parent)
        return "is between fragments of another body";
    const std::vector<PackNeighbour>& neighbours = pack.fragments[first].neighbours;
    const auto contact = std::ranges::find(neighbours, second, &PackNeighbour::fragment);
    if (contact == neighbours.end()) return "is between fragments that are not neighbours";
    if (contact->area != bond.area) {
        return "has an area of " + messageText(bond.area) + " m² instead of the contact's " +
               messageText(contact->area) + " m²";
    }
    if (!(std::abs(glm::length(bond.normal) - 1.0) <= kUnitTolerance)) return "has a normal that is not of length 1";
    if (!isInside(box, bond.centroid)) return "has a centroid outside of the whole";
    if (contact->centroid.value_or(bond.centroid) != bond.centroid ||
        contact->normal.value_or(bond.normal) != bond.normal)
        return "has another centroid or normal than the contact";
    if (bond.capacity && !(*bond.capacity >= 0.0)) return "has a negative capacity";
    return std::nullopt;
}

/// Each body that breaks: how many fragments and pairs of neighbours among them it has.
struct BodyCounts {
    std::size_t fragments = 0;
    std::size_t pairs = 0;
};

/// By body, the whole first.
std::map<std::int64_t, BodyCounts> countsOf(const Pack& pack) {
    std::map<std::int64_t, BodyCounts> counts;
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        const PackBody& body = pack.fragments[k];
        BodyCounts& parent = counts[body.parent == kNone ? -1 : std::int64_t{body.parent}];
        ++parent.fragments;
        parent.pairs += static_cast<std::size_t>(
            std::ranges::count_if(body.neighbours, [&](const PackNeighbour& other) { return other.fragment > k; }));
    }
    std::erase_if(counts, [](const auto& body) { return body.second.fragments < 2; });
    return counts;
}

BondErrorText verifyFracture(const Pack& pack, const PackFracture& fracture, std::size_t pairs, const Box3& box) {
    const std::string owner = "The bonds of " + bodyText(fracture.fragment) + ": ";
    for (std::size_t k = 0; k < fracture.bonds.size(); ++k) {
        const std::string place = owner + "bond " + std::to_string(k) + " ";
        if (k > 0 && fracture.bonds[k].fragments <= fracture.bonds[k - 1].fragments)
            return place + "is out of order; bonds must ascend.";
        if (BondErrorText error = verifyBond(pack, fracture.fragment, fracture.bonds[k], box))
            return place + *error + ".";
    }
    if (fracture.bonds.size() == pairs) return std::nullopt;
    return owner + "there are " + std::to_string(fracture.bonds.size()) + ", but " + std::to_string(pairs) +
           " pairs of neighbours.";
}

BondErrorText verifyFractures(const Pack& pack) {
    const std::vector<PackFracture>& fractures = pack.bonding->fractures;
    const std::map<std::int64_t, BodyCounts> counts = countsOf(pack);
    const Box3 box = boxOfWhole(pack);
    std::size_t k = 0;
    for (const auto& [body, count] : counts) {
        const std::uint32_t fragment = body < 0 ? kNone : static_cast<std::uint32_t>(body);
        if (k == fractures.size() || fractures[k].fragment != fragment)
            return "The bonds of " + bodyText(fragment) + " are missing or out of order.";
        if (BondErrorText error = verifyFracture(pack, fractures[k], count.pairs, box)) return error;
        ++k;
    }
    if (k == fractures.size()) return std::nullopt;
    return "There are bonds of " + bodyText(fractures[k].fragment) + ", which does not break.";
}

}  // namespace

std::optional<std::string> verifyPackBonding(const Pack& pack) {
    if (!pack.bonding) return std::nullopt;
    const PackBonding& bonding = *pack.bonding;
    if (!parseContentHash(bonding.bake)) {
        return "The hash of the bake, " + quotedName(bonding.bake) + ", is not 32 hexadecimal digits.";
    }
    if (BondErrorText error = verifyFractures(pack)) return error;
    for (std::size_t k = 0; k < bonding.anchored.size(); ++k) {
        const std::uint32_t fragment = bonding.anchored[k];
        const std::string place = "The anchored fragment " + std::to_string(fragment) + " ";
        if (fragment >= pack.fragments.size()) return place + "does not exist.";
        if (pack.fragments[fragment].parent != kNone) return place + "is not one of the whole.";
        if (k > 0 && fragment <= bonding.anchored[k - 1]) return place + "is out of order; they must ascend.";
    }
    return std::nullopt;
}

}  // namespace rubble
