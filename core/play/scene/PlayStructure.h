#pragma once

#include "core/asset/project/Variants.h"
#include "core/play/scene/PlayAsset.h"
#include "core/structure/bonds/MortarBonds.h"
#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"
#include "core/structure/rule/SimpleRule.h"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace rubble {

class SupportSpread;

/// The other half of a face that two instances have in common.
struct MortarLink {
    Id instance = 0;         // at the other side; 0: it is fixed, and does not break along bonds
    std::uint32_t bond = 0;  // of its structure
    bool operator==(const MortarLink&) const = default;
};

/// The fragments of a fracture, joined by bonds, prepared for play: shared by all of its bodies. Its nodes are the
/// fragments of the fracture, in order; its frame is the asset's.
struct PlayStructure {
    std::shared_ptr<const PlayAsset> asset;
    std::uint32_t parent = kNone;    // the fragment that is fractured; kNone: the whole
    BondGraph graph;                 // with the bonds to anchors, of which the last are mortar
    std::vector<double> volumes;     // m³, of each node
    std::vector<MortarLink> mortar;  // of these
    /// The instances that mortar joins with this one, directly or through others, ascending, itself among them; null:
    /// none.
    std::shared_ptr<const std::vector<Id>> joined;
    /// How all of these are supported at the start, with limits; null: none has a span, or there is no gravity.
    std::shared_ptr<const SupportSpread> supportAtStart;
    std::vector<double> capacities;           // N·s, of each bond; infinite: it never breaks
    std::vector<BondDamage> initialDamage;    // of each bond: those without capacity are broken from the start
    std::vector<ClusterLevel> clusterLevels;  // of the bonds between nodes; empty: there are no clusters
    SimpleRule rule;
    double leastImpulse = 0.0;        // N·s: a weaker hit breaks and damages nothing
    double span = 0.0;                // m; 0: any
    double collapseDelay = 0.0;       // s
    std::uint32_t minimumIsland = 1;  // nodes
    bool isJoined = true;             // bonds that are not broken from the start join all nodes
    bool holdsHeaviest = false;       // fixed, though it touches nothing that is: its heaviest island stays
    Vec3 up{0.0};                     // held, with a span: against the scene's gravity, in its frame
    /// Then, of each node: supportLimits(), m; or joinedSupportLimits() where mortar joins it.
    std::vector<double> supportLimits;
    std::vector<double> steps;  // m, where mortar joins it: sidewaysStep() of each link of the graph; 0 to anchors

    const PlayFracture& fracture() const { return *asset->fractureOf(parent); }
    std::uint32_t nodeCount() const { return graph.nodeCount(); }
    std::uint32_t fragmentOf(std::uint32_t node) const { return fracture().first + node; }
    const PlaySolid& solidOf(std::uint32_t node) const { return asset->fragments[fragmentOf(node)]; }
    /// All nodes, ascending.
    std::vector<std::uint32_t> allNodes() const;
    /// The first bond that is mortar.
    std::uint32_t firstMortar() const { return graph.bondCount() - static_cast<std::uint32_t>(mortar.size()); }
    /// The other half of a bond; null unless it is mortar between two structures.
    const MortarLink* mortarOf(std::uint32_t bond) const {
        const bool isMortar = bond >= firstMortar() && mortar[bond - firstMortar()].instance != 0;
        return isMortar ? &mortar[bond - firstMortar()] : nullptr;
    }
    /// The solid that all nodes together are.
    const PlaySolid& whole() const { return asset->solid(parent); }
    /// Whether anchors hold it at the start; some of its islands then may still be without one.
    bool isHeld() const;
    /// Whether it is supported up to a span only, where it is held.
    bool hasSpan() const { return span > 0.0 && !holdsHeaviest; }
    /// Sets the capacities of all bonds of the graph, and what follows from them.
    void setCapacities(std::vector<double> all);
};

/// The structure of a fracture of an asset, without anchors. `asset` is the variant that is baked.
std::shared_ptr<const PlayStructure> playStructure(const Asset& asset, const Material& material,
                                                   std::shared_ptr<const PlayAsset> ready, std::uint32_t parent);

/// Whether an instance of an asset is held in place: it is fixed, or breaks along bonds and is anchored or has painted
/// anchors.
bool isHeldInPlace(const Project& project, const Asset& asset, const Instance& instance);

/// Where the frame of an instance is in the world.
Pose poseOf(const Instance& instance);

/// The direction against gravity in a frame, of length 1; zero without gravity. Gravity is rounded as in a world.
Vec3 upIn(const Pose& frame, Vec3 gravity);

/// The limits of support of a structure that mortar does not join, with `up` in its frame: supportLimits(). Those that
/// it has, or others where gravity has changed.
std::vector<double> supportLimitsOf(const PlayStructure& structure, Vec3 up);

/// The structure of an instance with its limits of support against gravity, where it has any by itself.
std::shared_ptr<const PlayStructure> withSupportLimits(std::shared_ptr<const PlayStructure> structure,
                                                       const Instance& instance, Vec3 gravity);

/// The nodes of a structure, in a frame in which the structure's is at `pose`, as mortar and anchors see them.
std::vector<MortarNode> mortarNodes(const PlayStructure& structure, Id instance, const Pose& pose);

/// Something that bonded instances may be anchored to.
struct FixedSolid {
    Id instance = 0;              // 0: the ground
    std::vector<Polytope> hulls;  // m, in the world
};
/// The ground and all fixed instances that do not break along bonds themselves.
std::vector<FixedSolid> fixedSolids(const Project& project,
                                    const std::map<AssetVariant, std::shared_ptr<const PlayAsset>>& assets);

/// The structure of an instance, given that of its whole: with bonds to what it is anchored to. These are painted,
/// which hold whatever hits them; and, if it is fixed or anchored, to fixed solids that its fragments touch at most
/// kAnchorTolerance away.
std::shared_ptr<const PlayStructure> instanceStructure(const PlayStructure& whole, const Asset& asset,
                                                       const Material& material, const Instance& instance,
                                                       std::span<const FixedSolid> surroundings);
inline constexpr double kAnchorTolerance = 0.005;  // m

/// The same structure with bonds of `factor` times the strength.
std::shared_ptr<const PlayStructure> strengthened(const PlayStructure& structure, double factor);

}  // namespace rubble
