#include "core/play/breaking/MortarSupport.h"

#include "core/structure/graph/Support.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
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

    bool isBroken(std::uint32_t bond) const { return state != nullptr && state->damage[bond] == kBroken; }
    bool hasSpan() const { return structure->span > 0.0 && !structure->holdsHeaviest; }
    /// A distance as a fraction of the span.
    double fraction(double distance) const { return hasSpan() ? distance / structure->span : 0.0; }
};

std::vector<std::uint32_t> heldNodes(const JoinedMember& member, const PlayBody& body) {
    if (!body.nodes.empty()) return body.nodes;
    std::vector<std::uint32_t> all(member.structure->nodeCount());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// How far what lies at a bond's other end is sideways of one end, m.
double sidewaysOf(const Vec3& apart, const Vec3& up) { return glm::length(apart - glm::dot(apart, up) * up); }

/// The fractions of the span at which nodes are supported.
class SupportSpread {
public:
    SupportSpread(const SessionParts& parts, Vec3 up) {
        std::uint32_t count = 0;
        for (const auto& [instance, structure] : parts.scene.structures) {
            if (structure->mortar.empty()) continue;
            m_members[instance] = {.structure = structure.get(), .first = count};
            count += structure->nodeCount();
        }
        m_fractions.assign(count, kNotHeld);
        m_memberOf.resize(count);
        addBodies(parts, up);
    }

    void spread() {
        for (const auto& [instance, member] : m_members) addSources(member);
        while (!m_queue.empty()) {
            const auto [fraction, index] = m_queue.top();
            m_queue.pop();
            if (fraction > m_fractions[index]) continue;
            const JoinedMember& member = *m_memberOf[index];
            for (const BondLink& link : member.structure->graph.linksOf(index - member.first)) {
                if (!member.isBroken(link.bond)) follow(member, index - member.first, link, fraction);
            }
        }
    }

    UnsupportedNodes unsupported() const {
        UnsupportedNodes all;
        for (const auto& [instance, member] : m_members) {
            if (!member.hasSpan()) continue;
            for (const PlayBody* body : member.held) {
                std::vector<std::uint32_t> nodes = heldNodes(member, *body);
                std::erase_if(nodes, [&](std::uint32_t node) { return m_fractions[member.first + node] < kUnreached; });
                if (!nodes.empty()) all[body->number] = std::move(nodes);
            }
        }
        return all;
    }

private:
    void addBodies(const SessionParts& parts, Vec3 up) {
        for (const PlayBody& body : parts.state.bodies) {
            if (!body.isHeld) continue;
            const auto found = m_members.find(parts.state.origins[body.origin].instance);
            if (found == m_members.end()) continue;
            JoinedMember& member = found->second;
            if (body.structure != kNone) member.state = &parts.state.structures[body.structure];
            member.up = glm::conjugate(parts.world.state(body.body).pose.orientation) * up;
            member.held.push_back(&body);
            for (const std::uint32_t node : heldNodes(member, body)) m_fractions[member.first + node] = kUnreached;
        }
        for (const auto& [instance, member] : m_members) {
            const auto begin = m_memberOf.begin() + member.first;
            std::fill(begin, begin + member.structure->nodeCount(), &member);
        }
    }

    void addSources(const JoinedMember& member) {
        const PlayStructure& structure = *member.structure;
        for (std::uint32_t node = 0; node < structure.nodeCount(); ++node) {
            const auto isAnchor = [&](const BondLink& link) {
                return link.node == kNone && structure.mortarOf(link.bond) == nullptr && !member.isBroken(link.bond);
            };
            if (!member.hasSpan() || std::ranges::any_of(structure.graph.linksOf(node), isAnchor))
                reach(member, node, 0.0);
        }
    }

    void follow(const JoinedMember& member, std::uint32_t node, BondLink link, double fraction) {
        const PlayStructure& structure = *member.structure;
        if (link.node != kNone) {
            reach(member, link.node, fraction + member.fraction(sidewaysStep(structure.graph, node, link, member.up)));
        } else if (const MortarLink* mortar = structure.mortarOf(link.bond)) {
            const JoinedMember& other = m_members.at(mortar->instance);
            if (!other.isBroken(mortar->bond)) cross(member, link.bond, other, mortar->bond, fraction);
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
        reach(other, to.first, fraction + other.fraction(step));
    }

    void reach(const JoinedMember& member, std::uint32_t node, double fraction) {
        double& known = m_fractions[member.first + node];
        if (!(fraction <= 1.0) || !(fraction < known)) return;
        known = fraction;
        m_queue.push({fraction, member.first + node});
    }

    using Entry = std::pair<double, std::uint32_t>;

    std::map<Id, JoinedMember> m_members;
    std::vector<double> m_fractions;              // of each node
    std::vector<const JoinedMember*> m_memberOf;  // of each node
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
};

}  // namespace

UnsupportedNodes unsupportedByMortar(const SessionParts& parts) {
    const Vec3 gravity = parts.world.gravity();
    const auto hasSpan = [](const auto& entry) {
        const PlayStructure& structure = *entry.second;
        return !structure.mortar.empty() && structure.span > 0.0;
    };
    if (gravity == Vec3(0.0) || std::ranges::none_of(parts.scene.structures, hasSpan)) return {};
    SupportSpread support(parts, -glm::normalize(gravity));
    support.spread();
    return support.unsupported();
}

}  // namespace rubble
