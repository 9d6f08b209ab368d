#include "core/play/scene/JoinedSupport.h"

#include "core/structure/graph/Support.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace rubble {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kNotHeld = -1.0;

/// A structure, and what its nodes need in each step.
struct Member {
    const JoinedStructure* joined = nullptr;
    std::uint32_t first = 0;  // the index of its first node among all
    double perMetre = 0.0;    // of the span
    bool hasSpan = false;
    bool hasSteps = false;  // PlayStructure::steps are those against the present gravity

    const PlayStructure& structure() const { return *joined->structure; }
    const Vec3& up() const { return joined->up; }
    bool isBroken(std::uint32_t bond) const { return joined->damage[bond] == kBroken; }
    double stepOf(std::uint32_t node, std::uint32_t link) const {
        const BondGraph& graph = structure().graph;
        return hasSteps ? structure().steps[link] : sidewaysStep(graph, node, graph.links[link], up());
    }
};

/// How far what lies at a bond's other end is sideways of one end, m.
double sidewaysOf(const Vec3& apart, const Vec3& up) { return glm::length(apart - glm::dot(apart, up) * up); }

/// Nodes that wait, by fraction of the span. Within the span they are in buckets: those of the lowest come first, in
/// any order, and a node that is reached again at a smaller fraction waits again. Those beyond it come by fraction.
class WaitingNodes {
public:
    using Entry = std::pair<double, std::uint32_t>;

    void add(double fraction, std::uint32_t node) {
        if (fraction > 1.0) return m_beyond.push({fraction, node});
        const auto bucket = static_cast<std::size_t>(fraction * (kBuckets - 1));
        m_buckets[bucket].push_back({fraction, node});
        m_lowest = std::min(m_lowest, bucket);
    }
    std::optional<Entry> next() {
        while (m_lowest < kBuckets && m_buckets[m_lowest].empty()) ++m_lowest;
        if (m_lowest < kBuckets) {
            const Entry last = m_buckets[m_lowest].back();
            m_buckets[m_lowest].pop_back();
            return last;
        }
        if (m_beyond.empty()) return std::nullopt;
        const Entry nearest = m_beyond.top();
        m_beyond.pop();
        return nearest;
    }

private:
    static constexpr std::size_t kBuckets = 32;
    std::array<std::vector<Entry>, kBuckets> m_buckets;
    std::size_t m_lowest = kBuckets;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_beyond;
};

/// The fractions of the span at which nodes are supported: the least of all paths, whatever the order of visits.
class SupportSpread {
public:
    SupportSpread(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits) {
        std::uint32_t count = 0;
        for (const auto& [instance, one] : joined) {
            Member member{.joined = &one, .first = count, .hasSpan = one.structure->hasSpan()};
            member.perMetre = member.hasSpan ? 1.0 / one.structure->span : 0.0;
            member.hasSteps = !one.structure->steps.empty() && one.structure->up == one.up;
            m_members[instance] = member;
            count += one.structure->nodeCount();
        }
        m_fractions.assign(count, kNotHeld);
        m_limits.assign(count, kUnreached);
        m_memberOf.resize(count);
        for (const auto& [instance, member] : m_members) {
            for (const std::uint32_t node : member.joined->held) m_fractions[member.first + node] = kUnreached;
            std::fill_n(m_memberOf.begin() + member.first, member.structure().nodeCount(), &member);
            const auto own = limits.find(instance);
            if (own != limits.end()) std::ranges::copy(own->second, m_limits.begin() + member.first);
        }
    }

    void spread() {
        for (const auto& [instance, member] : m_members) addSources(member);
        while (const auto next = m_waiting.next()) {
            const auto [fraction, index] = *next;
            if (fraction > m_fractions[index]) continue;
            const Member& member = *m_memberOf[index];
            const BondGraph& graph = member.structure().graph;
            const std::uint32_t node = index - member.first;
            for (std::uint32_t link = graph.firstLink[node]; link < graph.firstLink[node + 1]; ++link)
                follow(member, node, link, fraction);
        }
    }

    NodeFractions fractions() const {
        NodeFractions all;
        for (const auto& [instance, member] : m_members) {
            const auto begin = m_fractions.begin() + member.first;
            std::vector<double>& own = all[instance];
            own.assign(begin, begin + member.structure().nodeCount());
            std::ranges::replace(own, kNotHeld, kUnreached);
        }
        return all;
    }

private:
    void addSources(const Member& member) {
        const PlayStructure& structure = member.structure();
        for (std::uint32_t node = 0; node < structure.nodeCount() && !member.hasSpan; ++node) reach(member, node, 0.0);
        const std::vector<Bond>& bonds = structure.graph.bonds;
        for (std::uint32_t bond = structure.graph.bondCount(); bond-- > 0 && bonds[bond].second == kNone;) {
            if (structure.mortarOf(bond) == nullptr && !member.isBroken(bond)) reach(member, bonds[bond].first, 0.0);
        }
    }

    void follow(const Member& member, std::uint32_t node, std::uint32_t link, double fraction) {
        const auto [next, bond] = member.structure().graph.links[link];
        if (next != kNone) {
            // Most neighbours are reached: the damage and the step need not be read.
            if (m_fractions[member.first + next] <= fraction || member.isBroken(bond)) return;
            reach(member, next, member.hasSpan ? fraction + member.perMetre * member.stepOf(node, link) : fraction);
        } else if (const MortarLink* mortar = member.structure().mortarOf(bond); mortar != nullptr) {
            const Member& other = m_members.at(mortar->instance);
            if (!member.isBroken(bond) && !other.isBroken(mortar->bond))
                cross(member, bond, other, mortar->bond, fraction);
        }
    }

    /// Goes on over mortar, given its halves.
    void cross(const Member& member, std::uint32_t half, const Member& other, std::uint32_t otherHalf,
               double fraction) {
        const Bond &from = member.structure().graph.bonds[half], &to = other.structure().graph.bonds[otherHalf];
        const double upwards = glm::dot(from.normal, member.up());
        if (upwards <= -kStandsOn) return;  // it would hang
        if (upwards >= kStandsOn) {
            reach(other, to.first, 0.0);
            return;
        }
        const double step = sidewaysOf(from.centroid - member.structure().graph.centres[from.first], member.up()) +
                            sidewaysOf(other.structure().graph.centres[to.first] - to.centroid, other.up());
        reach(other, to.first, fraction + other.perMetre * step);
    }

    void reach(const Member& member, std::uint32_t node, double fraction) {
        double& known = m_fractions[member.first + node];
        if (!(fraction <= m_limits[member.first + node]) || !(fraction < known)) return;
        known = fraction;
        m_waiting.add(fraction, member.first + node);
    }

    std::map<Id, Member> m_members;
    std::vector<double> m_fractions;        // of each node
    std::vector<double> m_limits;           // of each node
    std::vector<const Member*> m_memberOf;  // of each node
    WaitingNodes m_waiting;
};

}  // namespace

NodeFractions supportFractions(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits) {
    SupportSpread support(joined, limits);
    support.spread();
    return support.fractions();
}

NodeFractions joinedSupportLimits(const std::map<Id, JoinedStructure>& atStart) {
    NodeFractions limits = supportFractions(atStart);
    for (auto& [instance, fractions] : limits) {
        for (double& fraction : fractions) fraction = std::max(fraction, 1.0);
    }
    return limits;
}

JoinedStructure joinedAtStart(const PlayStructure& structure, Vec3 up) {
    JoinedStructure joined{&structure, structure.initialDamage, {}, up};
    joined.held.resize(structure.nodeCount());
    std::iota(joined.held.begin(), joined.held.end(), 0u);
    return joined;
}

}  // namespace rubble
