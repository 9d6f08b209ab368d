#include "core/play/scene/HangingLoads.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/DisjointSets.h"
#include "core/structure/graph/Support.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {
namespace {

constexpr double kMinLength = 1e-6;  // m, of a spring
constexpr double kStands = 0.1;      // of its load: what gives as much to what it stands on stands

/// A bond from a node to its neighbour, or to an anchor.
struct Hold {
    std::uint32_t node = kNone;  // number in the scene; kNone: an anchor
    double along = 0.0;          // the normal towards it by up
    double strength = 0.0;       // N
    double stiffness = 0.0;      // m: its area by the distance of what it joins
    bool isMortar = false;
};

/// Whether a node stands on what holds it.
bool isBelow(const Hold& hold) { return hold.along <= -kStandsOn; }

/// All nodes of held structures of a scene, numbered through.
class SceneNodes {
public:
    explicit SceneNodes(const PlayScene& scene) : m_scene(scene) {
        for (const Instance& instance : scene.project.instances) {
            const auto found = scene.structures.find(instance.id);
            if (found == scene.structures.end()) continue;
            const std::uint32_t first = count();
            m_parts.push_back({&instance, found->second.get(), first, upIn(poseOf(instance), scene.project.gravity)});
            m_first[instance.id] = first;
            m_partOf.resize(first + found->second->nodeCount(), static_cast<std::uint32_t>(m_parts.size() - 1));
        }
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(m_partOf.size()); }
    Id instanceOf(std::uint32_t number) const { return partOf(number).instance->id; }
    std::uint32_t nodeOf(std::uint32_t number) const { return number - partOf(number).first; }
    /// N
    double weightOf(std::uint32_t number) const {
        const Part& part = partOf(number);
        const Asset& asset = *findAsset(m_scene.project, part.instance->asset);
        const double density = findMaterial(m_scene.project, asset.material)->density;
        const Vec3& gravity = m_scene.project.gravity;
        return density * part.structure->volumes[nodeOf(number)] * std::sqrt(glm::dot(gravity, gravity));
    }
    /// Its bonds that hold at the start.
    std::vector<Hold> holdsOf(std::uint32_t number) const {
        const Part& part = partOf(number);
        const PlayStructure& structure = *part.structure;
        std::vector<Hold> holds;
        for (const BondLink& link : structure.graph.linksOf(nodeOf(number))) {
            if (structure.initialDamage[link.bond] == kBroken) continue;
            const Bond& bond = structure.graph.bonds[link.bond];
            const double direction = bond.first == nodeOf(number) ? 1.0 : -1.0;
            const MortarLink* mortar = structure.mortarOf(link.bond);
            const bool isMortar = link.bond >= structure.firstMortar();
            const std::uint32_t other = otherEnd(part, link, mortar);
            const double length =
                other == kNone ? bond.seedDistance : glm::distance(worldCentre(number), worldCentre(other));
            holds.push_back({.node = other,
                             .along = direction * glm::dot(bond.normal, part.up),
                             .strength = structure.capacities[link.bond] / contactTime(part, isMortar),
                             .stiffness = bond.area / std::max(length, kMinLength),
                             .isMortar = isMortar});
        }
        return holds;
    }
    /// Whether a structure stays in place without anchors.
    bool isHeldAnyway(std::uint32_t number) const { return partOf(number).structure->holdsHeaviest; }

private:
    struct Part {
        const Instance* instance;
        const PlayStructure* structure;
        std::uint32_t first;  // number of its first node
        Vec3 up;              // in the structure's frame
    };
    const Part& partOf(std::uint32_t number) const { return m_parts[m_partOf[number]]; }
    Vec3 worldCentre(std::uint32_t number) const {
        const Part& part = partOf(number);
        const Pose pose = poseOf(*part.instance);
        return pose.position + pose.orientation * part.structure->graph.centres[nodeOf(number)];
    }
    std::uint32_t otherEnd(const Part& part, const BondLink& link, const MortarLink* mortar) const {
        if (mortar == nullptr) return link.node == kNone ? kNone : part.first + link.node;
        const PlayStructure& other = *m_scene.structures.at(mortar->instance);
        return m_first.at(mortar->instance) + other.graph.bonds[mortar->bond].first;
    }
    double contactTime(const Part& part, bool isMortar) const {
        if (isMortar) return kDefaultContactTime;
        return findAsset(m_scene.project, part.instance->asset)->contactTime.value_or(kDefaultContactTime);
    }

    const PlayScene& m_scene;
    std::vector<Part> m_parts;
    std::map<Id, std::uint32_t> m_first;
    std::vector<std::uint32_t> m_partOf;  // of each number
};

using Holds = std::vector<std::vector<Hold>>;

/// Of each node, whether bonds connect it with an anchor, or with what stays in place without one.
std::vector<bool> heldNodes(const SceneNodes& nodes, const Holds& holds) {
    DisjointSets sets(nodes.count() + 1);
    const std::uint32_t anchor = nodes.count();
    for (std::uint32_t number = 0; number < nodes.count(); ++number) {
        if (nodes.isHeldAnyway(number)) sets.merge(number, anchor);
        for (const Hold& hold : holds[number]) sets.merge(number, hold.node == kNone ? anchor : hold.node);
    }
    std::vector<bool> held(nodes.count());
    for (std::uint32_t number = 0; number < nodes.count(); ++number)
        held[number] = sets.rootOf(number) == sets.rootOf(anchor);
    return held;
}

/// How far nodes sink under their weights, as if their bonds were springs, in N/m per metre of stiffness. Anchors and
/// nodes that stay in place do not sink, and those that nothing holds are left out.
/// Source: Hestenes, Stiefel 1952, "Methods of conjugate gradients for solving linear systems"; preconditioned by the
/// diagonal.
class Sinking {
public:
    Sinking(const SceneNodes& nodes, const Holds& holds, const std::vector<bool>& held)
        : m_holds(holds), m_isFree(nodes.count()), m_diagonal(nodes.count()), m_depths(nodes.count(), 0.0) {
        std::vector<double> rest(nodes.count(), 0.0);
        for (std::uint32_t number = 0; number < nodes.count(); ++number) {
            m_isFree[number] = held[number] && !nodes.isHeldAnyway(number);
            for (const Hold& hold : holds[number]) m_diagonal[number] += hold.stiffness;
            if (m_isFree[number]) rest[number] = nodes.weightOf(number);
        }
        solve(std::move(rest));
    }
    double depth(std::uint32_t number) const { return number == kNone ? 0.0 : m_depths[number]; }
    /// The force that a bond takes of a node, N.
    double force(std::uint32_t number, const Hold& hold) const {
        return hold.stiffness * (depth(number) - depth(hold.node));
    }

private:
    static double product(std::span<const double> a, std::span<const double> b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    }
    /// The forces that hold nodes at their depths.
    std::vector<double> forces(std::span<const double> depths) const {
        std::vector<double> forces(depths.size(), 0.0);
        for (std::uint32_t number = 0; number < depths.size(); ++number) {
            if (!m_isFree[number]) continue;
            for (const Hold& hold : m_holds[number])
                forces[number] += hold.stiffness * (depths[number] - (hold.node == kNone ? 0.0 : depths[hold.node]));
        }
        return forces;
    }
    void solve(std::vector<double> rest) {
        constexpr double kPrecision = 1e-6;  // of the weights
        const double enough = kPrecision * kPrecision * product(rest, rest);
        const auto preconditioned = [&] {
            std::vector<double> result(rest);
            for (std::size_t k = 0; k < result.size(); ++k)
                if (m_isFree[k]) result[k] /= m_diagonal[k];
            return result;
        };
        std::vector<double> scaled = preconditioned(), direction = scaled;
        double size = product(rest, scaled);
        for (std::size_t k = 0; k < 10 * rest.size() && product(rest, rest) > enough; ++k) {
            const std::vector<double> change = forces(direction);
            const double step = size / product(direction, change);
            for (std::size_t n = 0; n < rest.size(); ++n) {
                m_depths[n] += step * direction[n];
                rest[n] -= step * change[n];
            }
            scaled = preconditioned();
            const double next = product(rest, scaled);
            for (std::size_t n = 0; n < rest.size(); ++n) direction[n] = scaled[n] + next / size * direction[n];
            size = next;
        }
    }

    const Holds& m_holds;
    std::vector<bool> m_isFree;
    std::vector<double> m_diagonal;
    std::vector<double> m_depths;
};

}  // namespace

std::vector<HangingLoad> hangingLoads(const PlayScene& scene) {
    if (scene.project.gravity == Vec3(0.0)) return {};
    const SceneNodes nodes(scene);
    Holds holds;
    for (std::uint32_t number = 0; number < nodes.count(); ++number) holds.push_back(nodes.holdsOf(number));
    const std::vector<bool> held = heldNodes(nodes, holds);
    const Sinking sinking(nodes, holds, held);
    std::vector<HangingLoad> hanging;
    for (std::uint32_t number = 0; number < nodes.count(); ++number) {
        if (!held[number] || nodes.isHeldAnyway(number)) continue;
        HangingLoad one{nodes.instanceOf(number), nodes.nodeOf(number)};
        double mortar = 0.0, below = 0.0;  // N
        for (const Hold& hold : holds[number]) {
            const double force = sinking.force(number, hold);
            if (!(force > 0.0)) continue;
            one.load += force;
            one.strength += hold.strength;
            mortar += hold.isMortar ? force : 0.0;
            below += isBelow(hold) ? force : 0.0;
        }
        one.mortar = one.load > 0.0 ? mortar / one.load : 0.0;
        if (below < kStands * one.load && std::isfinite(one.strength)) hanging.push_back(one);
    }
    return hanging;
}

}  // namespace rubble
