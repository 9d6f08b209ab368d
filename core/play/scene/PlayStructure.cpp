#include "core/play/scene/PlayStructure.h"

#include "core/base/Assert.h"
#include "core/play/scene/GroundHull.h"
#include "core/structure/capacity/BondCapacities.h"
#include "core/structure/graph/Islands.h"
#include "core/structure/graph/Support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rubble {
namespace {

constexpr double kMinAnchorArea = 1e-6;  // m²: less is a corner or an edge

/// The index of the fracture of a fragment in its bake; kNone: of the whole.
std::uint32_t fractureIndex(const Bake& bake, std::uint32_t parent) {
    return static_cast<std::uint32_t>(bake.fractureOf(parent) - bake.fractures.data());
}

/// Hulls in another frame, in which theirs is at `pose`.
std::vector<Polytope> placedAll(std::vector<Polytope> hulls, const Pose& pose) {
    for (Polytope& hull : hulls) hull = placed(std::move(hull), pose);
    return hulls;
}

/// Bonds that hold painted fragments.
std::vector<Bond> paintedAnchors(const Asset& asset, const Bake& bake) {
    std::vector<Bond> anchors;
    for (const std::uint32_t node : anchoredFragments(asset, bake, 0)) {
        anchors.push_back(paintedAnchor(bake.fractures.front().fragments, node));
    }
    return anchors;
}

/// Bonds to the solids that the fragments of an instance touch.
std::vector<Bond> touchedAnchors(const PlayStructure& whole, const Instance& instance,
                                 std::span<const FixedSolid> surroundings) {
    const Pose pose = poseOf(instance);
    const Quat back = glm::conjugate(pose.orientation);
    std::vector<Polytope> supports;  // in the asset's frame
    for (const FixedSolid& solid : surroundings) {
        if (solid.instance == instance.id) continue;
        for (Polytope& hull : placedAll(solid.hulls, {back * -pose.position, back}))
            supports.push_back(std::move(hull));
    }
    const std::vector<MortarNode> nodes = mortarNodes(whole, instance.id, {});
    return anchorBonds(nodes, supports, kAnchorTolerance, kMinAnchorArea);
}

}  // namespace

bool isHeldInPlace(const Project& project, const Asset& asset, const Instance& instance) {
    if (instance.isFixed || asset.breakAs == BreakAs::Whole || project.damage.isThesis) return instance.isFixed;
    const auto isAnchor = [](const BondStroke& stroke) {
        return stroke.brush == BondBrush::Anchor && !stroke.isErasing;
    };
    return instance.isAnchored || std::ranges::any_of(asset.bonding.strokes, isAnchor);
}

Pose poseOf(const Instance& instance) { return {instance.pose.position, glm::normalize(instance.pose.orientation)}; }

Vec3 upIn(const Pose& frame, Vec3 gravity) {
    if (gravity == Vec3(0.0)) return Vec3(0.0);
    return glm::conjugate(frame.orientation) * -glm::normalize(Vec3(glm::vec3(gravity)));
}

std::vector<MortarNode> mortarNodes(const PlayStructure& structure, Id instance, const Pose& pose) {
    std::vector<MortarNode> nodes;
    for (std::uint32_t node = 0; node < structure.nodeCount(); ++node) {
        const Fragment fragment = structure.asset->bake->fragment(structure.fragmentOf(node)).solid;
        const Pose frame{pose.position + pose.orientation * fragment.offset(), pose.orientation};
        nodes.push_back({.body = instance,
                         .centre = pose.position + pose.orientation * structure.graph.centres[node],
                         .hulls = placedAll(fragment.hulls(), frame)});
    }
    return nodes;
}

std::vector<std::uint32_t> PlayStructure::allNodes() const {
    std::vector<std::uint32_t> nodes(nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0u);
    return nodes;
}

bool PlayStructure::isHeld() const {
    if (holdsHeaviest) return true;
    for (std::uint32_t bond = 0; bond < graph.bondCount(); ++bond)
        if (graph.bonds[bond].second == kNone && initialDamage[bond] != kBroken) return true;
    return false;
}

void PlayStructure::setCapacities(std::vector<double> all) {
    capacities = std::move(all);
    initialDamage.clear();
    std::vector<double> holding;
    for (const double capacity : capacities) {
        initialDamage.push_back(capacity > 0.0 ? kIntact : kBroken);
        if (capacity > 0.0) holding.push_back(capacity);
    }
    leastImpulse = rubble::leastImpulse(holding, rule);
    isJoined = islandsOf(graph, initialDamage, allNodes()).count() <= 1;
}

std::vector<double> supportLimitsOf(const PlayStructure& structure, Vec3 up) {
    if (!structure.supportLimits.empty() && structure.up == up) return structure.supportLimits;
    return supportLimits(structure.graph, structure.initialDamage, structure.span, up);
}

std::shared_ptr<const PlayStructure> withSupportLimits(std::shared_ptr<const PlayStructure> structure,
                                                       const Instance& instance, Vec3 gravity) {
    if (!structure->hasSpan() || !structure->isHeld() || !structure->mortar.empty() || gravity == Vec3(0.0))
        return structure;
    auto made = std::make_shared<PlayStructure>(*structure);
    made->up = upIn(poseOf(instance), gravity);
    made->supportLimits = supportLimitsOf(*made, made->up);
    return made;
}

std::vector<FixedSolid> fixedSolids(const Project& project,
                                    const std::map<AssetVariant, std::shared_ptr<const PlayAsset>>& assets) {
    std::vector<FixedSolid> solids;
    if (project.ground.isOn) solids.push_back({0, {translated(*groundHull(), {0.0, project.ground.height, 0.0})}});
    for (const Instance& instance : project.instances) {
        const auto asset = assets.find(variantOf(instance));
        if (!instance.isFixed || asset == assets.end() || asset->second->isBonded) continue;
        solids.push_back({instance.id, placedAll(wholeHullsInPrism(*asset->second->bake), poseOf(instance))});
    }
    return solids;
}

std::shared_ptr<const PlayStructure> playStructure(const Asset& asset, const Material& material,
                                                   std::shared_ptr<const PlayAsset> ready, std::uint32_t parent) {
    const Bake& bake = *ready->bake;
    const std::uint32_t fracture = fractureIndex(bake, parent);
    const BakedFracture& baked = bake.fractures[fracture];
    std::vector<Bond> bonds = bondsOf(baked);
    std::vector<double> capacities = bondCapacities(asset, material, bake, fracture, bonds);
    std::vector<ClusterLevel> levels = clusterLevels(asset, bake, fracture, bonds);
    std::vector<Vec3> centres;
    std::vector<double> volumes;
    for (std::uint32_t node = 0; node < baked.fragments.count(); ++node) {
        const PlaySolid& solid = ready->fragments[baked.first + node];
        centres.push_back(centreInAsset(solid));
        volumes.push_back(solid.shape->mass.volume);
    }
    const SimpleRule rule = simpleRuleOf(asset.bonding);
    auto made = std::make_shared<PlayStructure>(PlayStructure{.asset = std::move(ready),
                                                              .parent = parent,
                                                              .graph = bondGraph(std::move(centres), std::move(bonds)),
                                                              .volumes = std::move(volumes),
                                                              .clusterLevels = std::move(levels),
                                                              .rule = rule,
                                                              .span = asset.bonding.span,
                                                              .collapseDelay = asset.bonding.collapseDelay,
                                                              .minimumIsland = asset.bonding.minimumIsland});
    made->setCapacities(std::move(capacities));
    return made;
}

std::shared_ptr<const PlayStructure> instanceStructure(const PlayStructure& whole, const Asset& asset,
                                                       const Material& material, const Instance& instance,
                                                       std::span<const FixedSolid> surroundings) {
    auto made = std::make_shared<PlayStructure>(*strengthened(whole, instance.bondStrength));
    const Bake& bake = *whole.asset->bake;
    std::vector<Bond> bonds = made->graph.bonds;
    std::vector<double> capacities = made->capacities;
    const auto add = [&](const std::vector<Bond>& anchors, const std::vector<double>& held) {
        bonds.insert(bonds.end(), anchors.begin(), anchors.end());
        capacities.insert(capacities.end(), held.begin(), held.end());
    };
    const std::vector<Bond> painted = paintedAnchors(asset, bake);
    add(painted, std::vector<double>(painted.size(), std::numeric_limits<double>::infinity()));
    if (instance.isAnchored || instance.isFixed) {
        const std::vector<Bond> touched = touchedAnchors(whole, instance, surroundings);
        add(touched, bondCapacities(asset, material, bake, 0, touched, instance.bondStrength));
    }
    made->holdsHeaviest = instance.isFixed && bonds.size() == whole.graph.bonds.size();
    made->graph = bondGraph(made->graph.centres, std::move(bonds));
    made->setCapacities(std::move(capacities));
    return made;
}

std::shared_ptr<const PlayStructure> strengthened(const PlayStructure& structure, double factor) {
    auto made = std::make_shared<PlayStructure>(structure);
    std::vector<double> capacities = structure.capacities;
    for (double& capacity : capacities) capacity = std::isfinite(capacity) ? capacity * factor : capacity;
    made->setCapacities(std::move(capacities));
    return made;
}

}  // namespace rubble
