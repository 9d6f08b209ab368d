#include "core/play/breaking/MortarSupport.h"

#include "core/structure/graph/Support.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace rubble {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kNotHeld = -1.0;

/// A structure that mortar joins, with the nodes of it that are held.
struct JoinedMember {
    const PlayStructure* structure = nullptr;
    const StructureState* state = nullptr;  // null: intact
    std::vector<const PlayBody*> held;
    std::uint32_t first = 0;  // the index of its first node among all
    Vec3 up{0.0};             // in its frame
    bool hasSpan = false;
    double perMetre = 0.0;  // of the span
    bool hasSteps = false;  // PlayStructure::steps are those against the present gravity

    bool isBroken(std::uint32_t bond) const { return state != nullptr && state->damage[bond] == kBroken; }
    double stepOf(std::uint32_t node, std::uint32_t link) const {
        const BondGraph& graph = structure->graph;
        return hasSteps ? structure->steps[link] : sidewaysStep(graph, node, graph.links[link], up);
    }
};

JoinedMember memberOf(const SessionParts& parts, Id instance, const PlayStructure& structure, std::uint32_t first) {
    JoinedMember member{.structure = &structure, .first = first};
    member.up = upIn(poseOf(*findInstance(parts.scene.project, instance)), parts.world.gravity());
    member.hasSpan = structure.span > 0.0 && !structure.holdsHeaviest;
    member.perMetre = member.hasSpan ? 1.0 / structure.span : 0.0;
    member.hasSteps = !structure.steps.empty() && structure.up == member.up;
    return member;
}

template <class Visit>
void visitHeldNodes(const JoinedMember& member, const PlayBody& body, const Visit& visit) {
    for (const std::uint32_t node : body.nodes) visit(node);
    if (!body.nodes.empty()) return;
    for (std::uint32_t node = 0; node < member.structure->nodeCount(); ++node) visit(node);
}

/// How far what lies at a bond's other end is sideways of one end, m.
double sidewaysOf(const Vec3& apart, const Vec3& up) { return glm::length(apart - glm::dot(apart, up) * up); }

/// Nodes that wait, by fraction of the span in steps of a bucket: those of the lowest bucket come first, in any order.
/// A node that is reached again at a smaller fraction waits again.
class WaitingNodes {
public:
    void add(double fraction, std::uint32_t node) {
        const auto bucket = static_cast<std::size_t>(fraction * (kBuckets - 1));
        m_buckets[bucket].push_back({fraction, node});
        m_lowest = std::min(m_lowest, bucket);
    }
    std::optional<std::pair<double, std::uint32_t>> next() {
        while (m_lowest < kBuckets && m_buckets[m_lowest].empty()) ++m_lowest;
        if (m_lowest == kBuckets) return std::nullopt;
        const auto last = m_buckets[m_lowest].back();
        m_buckets[m_lowest].pop_back();
        return last;
    }

private:
    static constexpr std::size_t kBuckets = 32;
    std::array<std::vector<std::pair<double, std::uint32_t>>, kBuckets> m_buckets;
    std::size_t m_lowest = kBuckets;
};

/// The fractions of the span at which nodes are supported: the least of all paths, whatever the order of visits.
class SupportSpread {
public:
    explicit SupportSpread(const SessionParts& parts) {
        std::uint32_t count = 0;
        for (const auto& [instance, structure] : parts.scene.structures) {
            if (structure->mortar.empty()) continue;
            m_members[instance] = memberOf(parts, instance, *structure, count);
            count += structure->nodeCount();
        }
        m_fractions.assign(count, kNotHeld);
        m_memberOf.resize(count);
        addBodies(parts);
    }

    void spread() {
        for (const auto& [instance, member] : m_members) addSources(member);
        while (const auto next = m_waiting.next()) {
            const auto [fraction, index] = *next;
            if (fraction > m_fractions[index]) continue;
            const JoinedMember& member = *m_memberOf[index];
            const BondGraph& graph = member.structure->graph;
            const std::uint32_t node = index - member.first;
            for (std::uint32_t link = graph.firstLink[node]; link < graph.firstLink[node + 1]; ++link)
                follow(member, node, link, fraction);
        }
    }

    UnsupportedNodes unsupported() const {
        UnsupportedNodes all;
        for (const auto& [instance, member] : m_members) {
            if (!member.hasSpan) continue;
            for (const PlayBody* body : member.held) {
                std::vector<std::uint32_t> nodes;
                visitHeldNodes(member, *body, [&](std::uint32_t node) {
                    if (m_fractions[member.first + node] == kUnreached) nodes.push_back(node);
                });
                if (!nodes.empty()) all[body->number] = std::move(nodes);
            }
        }
        return all;
    }

private:
    void addBodies(const SessionParts& parts) {
        for (const PlayBody& body : parts.state.bodies) {
            if (!body.isHeld) continue;
            const auto found = m_members.find(parts.state.origins[body.origin].instance);
            if (found == m_members.end()) continue;
            JoinedMember& member = found->second;
            if (body.structure != kNone) member.state = &parts.state.structures[body.structure];
            member.held.push_back(&body);
            visitHeldNodes(member, body, [&](std::uint32_t node) { m_fractions[member.first + node] = kUnreached; });
        }
        for (const auto& [instance, member] : m_members) {
            const auto begin = m_memberOf.begin() + member.first;
            std::fill(begin, begin + member.structure->nodeCount(), &member);
        }
    }

    void addSources(const JoinedMember& member) {
        const PlayStructure& structure = *member.structure;
        for (std::uint32_t node = 0; node < structure.nodeCount() && !member.hasSpan; ++node) reach(member, node, 0.0);
        const std::vector<Bond>& bonds = structure.graph.bonds;
        for (std::uint32_t bond = structure.graph.bondCount(); bond-- > 0 && bonds[bond].second == kNone;) {
            if (structure.mortarOf(bond) == nullptr && !member.isBroken(bond)) reach(member, bonds[bond].first, 0.0);
        }
    }

    void follow(const JoinedMember& member, std::uint32_t node, std::uint32_t link, double fraction) {
        const auto [next, bond] = member.structure->graph.links[link];
        if (next != kNone) {
            // Most neighbours are reached: the damage and the step need not be read.
            if (m_fractions[member.first + next] <= fraction || member.isBroken(bond)) return;
            reach(member, next, member.hasSpan ? fraction + member.perMetre * member.stepOf(node, link) : fraction);
        } else if (const MortarLink* mortar = member.structure->mortarOf(bond); mortar != nullptr) {
            const JoinedMember& other = m_members.at(mortar->instance);
            if (!member.isBroken(bond) && !other.isBroken(mortar->bond))
                cross(member, bond, other, mortar->bond, fraction);
        }
    }

    /// Goes on over mortar, given its halves.
    void cross(const JoinedMember& member, std::uint32_t half, const JoinedMember& other, std::uint32_t otherHalf,
               double fraction) {
        const Bond &from = member.structure->graph.bonds[half], &to = other.structure->graph.bonds[otherHalf];
        const double upwards = glm::dot(from.normal, member.up);
        if (upwards <= -kStandsOn) return;  // it would hang
        if (upwards >= kStandsOn) {
            reach(other, to.first, 0.0);
            return;
        }
        const double step = sidewaysOf(from.centroid - member.structure->graph.centres[from.first], member.up) +
                            sidewaysOf(other.structure->graph.centres[to.first] - to.centroid, other.up);
        reach(other, to.first, fraction + other.perMetre * step);
    }

    void reach(const JoinedMember& member, std::uint32_t node, double fraction) {
        double& known = m_fractions[member.first + node];
        if (!(fraction <= 1.0) || !(fraction < known)) return;
        known = fraction;
        m_waiting.add(fraction, member.first + node);
    }

    std::map<Id, JoinedMember> m_members;
    std::vector<double> m_fractions;              // of each node
    std::vector<const JoinedMember*> m_memberOf;  // of each node
    WaitingNodes m_waiting;
};

}  // namespace

UnsupportedNodes unsupportedByMortar(const SessionParts& parts) {
    const auto hasSpan = [](const auto& entry) {
        const PlayStructure& structure = *entry.second;
        return !structure.mortar.empty() && structure.span > 0.0;
    };
    if (parts.world.gravity() == Vec3(0.0) || std::ranges::none_of(parts.scene.structures, hasSpan)) return {};
    SupportSpread support(parts);
    support.spread();
    return support.unsupported();
}

}  // namespace rubble
