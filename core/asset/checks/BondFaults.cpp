#include "core/asset/checks/BondFaults.h"

#include "core/asset/project/Names.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"

#include <map>
#include <set>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

Sentence strokeFault(const std::string& owner, const BondStroke& stroke) {
    if (Sentence fault = rangeFault(
            owner, {{ProjectNumber::BondStrength, stroke.strength}, {ProjectNumber::BondBrushRadius, stroke.radius}})) {
        return fault;
    }
    if (stroke.points.empty()) return owner + " has no points, but it must have at least one.";
    for (std::size_t k = 0; k < stroke.points.size(); ++k) {
        const std::string point = " of point " + std::to_string(k), x = "x" + point, y = "y" + point;
        if (Sentence fault = rangeFault(owner, {{ProjectNumber::OutlineCoordinate, stroke.points[k].x, x.c_str()},
                                                {ProjectNumber::OutlineCoordinate, stroke.points[k].y, y.c_str()}})) {
            return fault;
        }
    }
    return std::nullopt;
}

Sentence heightsFault(const std::string& owner, const std::vector<HeightStrength>& strengths) {
    const HeightStrength* before = nullptr;
    for (const HeightStrength& strength : strengths) {
        const std::string name = "bond strength at height " + messageText(strength.height);
        if (Sentence fault =
                rangeFault(owner, {{ProjectNumber::BondStrengthHeight, strength.height, "height of a bond strength"},
                                   {ProjectNumber::BondStrength, strength.factor, name.c_str()}})) {
            return fault;
        }
        if (before && before->height >= strength.height) {
            return owner + ": the " + name + " comes after that at height " + messageText(before->height) +
                   "; heights must ascend.";
        }
        before = &strength;
    }
    return std::nullopt;
}

Sentence imageFault(const std::string& owner, const StrengthImage& strength) {
    if (Sentence fault =
            rangeFault(owner, {{ProjectNumber::BondStrength, strength.darkest, "bond strength where it is black"},
                               {ProjectNumber::BondStrength, strength.brightest, "bond strength where it is white"}})) {
        return fault;
    }
    if (!strength.image) return std::nullopt;
    const Sentence fault = verifyGreyImage(*strength.image);
    return fault ? Sentence(owner + ": " + *fault + ".") : std::nullopt;
}

Sentence neverBreaksFault(const std::string& owner, const std::vector<FragmentPath>& paths) {
    const FragmentPath* before = nullptr;
    for (const FragmentPath& path : paths) {
        if (!isFragmentPath(path)) return owner + ": " + quotedName(path) + " is not a fragment path.";
        if (before && *before >= path) {
            return owner + ": fragment " + path + ", which never breaks, comes after " + *before +
                   "; paths must ascend.";
        }
        before = &path;
    }
    return std::nullopt;
}

/// The fault of one cluster, given those of its level before it.
Sentence clusterFault(const std::string& owner, const FragmentCluster& cluster, std::set<FragmentPath>& before) {
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::BondClusterLevel, static_cast<double>(cluster.level)}}))
        return fault;
    if (cluster.fragments.empty()) return owner + " has no fragments, but it must have at least one.";
    const FragmentPath* previous = nullptr;
    for (const FragmentPath& path : cluster.fragments) {
        if (!isFragmentPath(path)) return owner + ": " + quotedName(path) + " is not a fragment path.";
        if (previous && *previous >= path) {
            return owner + ": fragment " + path + " comes after " + *previous + "; paths must ascend.";
        }
        if (parentOf(path) != parentOf(cluster.fragments.front())) {
            return owner + ": fragments " + cluster.fragments.front() + " and " + path + " have different parents.";
        }
        if (!before.insert(path).second) {
            return owner + ": fragment " + path + " is in another cluster of level " + std::to_string(cluster.level) +
                   " already.";
        }
        previous = &path;
    }
    return std::nullopt;
}

Sentence clustersFault(const std::string& owner, const std::vector<FragmentCluster>& clusters) {
    std::map<std::uint32_t, std::set<FragmentPath>> ofLevels;
    for (std::size_t k = 0; k < clusters.size(); ++k) {
        const std::string one = owner + ": cluster " + std::to_string(k);
        if (Sentence fault = clusterFault(one, clusters[k], ofLevels[clusters[k].level])) return fault;
        if (k > 0 && clusters[k - 1] >= clusters[k])
            return one + " is out of order; clusters must ascend by level, then by fragments.";
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> bondFault(const Asset& asset) {
    const std::string owner = ownerText("Asset", asset.id, asset.name);
    const Bonding& bonding = asset.bonding;
    if (Sentence fault = rangeFault(
            owner, {{ProjectNumber::BondImpulse, bonding.impulsePerArea.value_or(1.0), "impulse per area of bonds"},
                    {ProjectNumber::BondLoadRadius, bonding.radius},
                    {ProjectNumber::BondDamageFrom, bonding.damageFrom},
                    {ProjectNumber::BondSpan, bonding.span, "span of bonds"},
                    {ProjectNumber::BondCollapseDelay, bonding.collapseDelay},
                    {ProjectNumber::BondMinimumIsland, static_cast<double>(bonding.minimumIsland)}})) {
        return fault;
    }
    for (std::size_t k = 0; k < bonding.strokes.size(); ++k) {
        if (Sentence fault = strokeFault(owner + ": bond stroke " + std::to_string(k), bonding.strokes[k]))
            return fault;
    }
    if (Sentence fault = heightsFault(owner, bonding.heightStrengths)) return fault;
    if (bonding.strengthImage) {
        if (Sentence fault = imageFault(owner + ": the strength image", *bonding.strengthImage)) return fault;
    }
    if (Sentence fault = neverBreaksFault(owner, bonding.neverBreaks)) return fault;
    return clustersFault(owner, bonding.clusters);
}

std::optional<std::string> faultOf(const Mortar& mortar) {
    return rangeFault(ownerText("Mortar", mortar.id, mortar.name),
                      {{ProjectNumber::MortarTolerance, mortar.tolerance},
                       {ProjectNumber::MortarLeastArea, mortar.leastArea},
                       {ProjectNumber::BondImpulse, mortar.impulsePerArea}});
}

}  // namespace rubble
