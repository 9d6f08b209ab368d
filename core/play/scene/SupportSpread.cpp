#include "core/play/scene/SupportSpread.h"

#include "core/base/Assert.h"
#include "core/structure/graph/Support.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kNotHeld = -1.0;

/// How far what lies at a bond's other end is sideways of one end, m.
double sidewaysOf(const Vec3& apart, const Vec3& up) { return glm::length(apart - glm::dot(apart, up) * up); }

}  // namespace

void WaitingNodes::add(double fraction, std::uint32_t node) {
    if (fraction > 1.0) return m_beyond.push({fraction, node});
    const auto bucket = static_cast<std::size_t>(fraction * (kBuckets - 1));
    m_buckets[bucket].push_back({fraction, node});
    m_lowest = std::min(m_lowest, bucket);
}

std::optional<WaitingNodes::Entry> WaitingNodes::next() {
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

double SupportSpread::Member::stepOf(std::uint32_t node, std::uint32_t link) const {
    return hasSteps ? structure->steps[link] : sidewaysStep(structure->graph, node, structure->graph.links[link], up);
}

SupportSpread::SupportSpread(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits) {
    for (const auto& [instance, one] : joined) addMember(instance, one);
    m_limits.assign(m_fractions.size(), kUnreached);
    m_lastLowering.assign(m_fractions.size(), kNone);
    m_memberOf.resize(m_fractions.size());
    for (std::uint32_t k = 0; k < m_members.size(); ++k) {
        const Member& member = m_members[k];
        std::fill_n(m_memberOf.begin() + member.first, member.structure->nodeCount(), k);
        const auto own = limits.find(member.instance);
        if (own != limits.end()) std::ranges::copy(own->second, m_limits.begin() + member.first);
    }
    for (const Member& member : m_members) addSources(member);
    spreadFromWaiting();
}

void SupportSpread::addMember(Id instance, const JoinedStructure& joined) {
    const PlayStructure& structure = *joined.structure;
    Member member{.instance = instance,
                  .structure = &structure,
                  .up = joined.up,
                  .damage = {joined.damage.begin(), joined.damage.end()},
                  .first = static_cast<std::uint32_t>(m_fractions.size()),
                  .hasSpan = structure.hasSpan()};
    if (!m_members.empty()) {
        const Member& last = m_members.back();
        member.firstBond = last.firstBond + last.structure->graph.bondCount();
    }
    member.perMetre = member.hasSpan ? 1.0 / structure.span : 0.0;
    member.hasSteps = !structure.steps.empty() && structure.up == joined.up;
    m_fractions.resize(member.first + structure.nodeCount(), kNotHeld);
    for (const std::uint32_t node : joined.held) m_fractions[member.first + node] = kUnreached;
    m_members.push_back(std::move(member));
}

void SupportSpread::addSources(const Member& member) {
    const PlayStructure& structure = *member.structure;
    for (std::uint32_t node = 0; node < structure.nodeCount() && !member.hasSpan; ++node)
        reach(member, node, 0.0, kNone);
    const std::vector<Bond>& bonds = structure.graph.bonds;
    for (std::uint32_t bond = structure.graph.bondCount(); bond-- > 0 && bonds[bond].second == kNone;) {
        if (structure.mortarOf(bond) == nullptr && !member.isBroken(bond))
            reach(member, bonds[bond].first, 0.0, member.firstBond + bond);
    }
}

void SupportSpread::spreadFromWaiting() {
    while (const auto next = m_waiting.next()) {
        const auto [fraction, index] = *next;
        if (fraction > m_fractions[index]) continue;
        ++m_visits;
        const Member& member = memberOfNode(index);
        const BondGraph& graph = member.structure->graph;
        const std::uint32_t node = index - member.first;
        for (std::uint32_t link = graph.firstLink[node]; link < graph.firstLink[node + 1]; ++link)
            follow(member, node, link, fraction);
    }
}

void SupportSpread::follow(const Member& member, std::uint32_t node, std::uint32_t link, double fraction) {
    const auto [next, bond] = member.structure->graph.links[link];
    if (next != kNone) {
        // Most neighbours are reached: the damage and the step need not be read.
        if (m_fractions[member.first + next] <= fraction || member.isBroken(bond)) return;
        reach(member, next, member.hasSpan ? fraction + member.perMetre * member.stepOf(node, link) : fraction,
              member.firstBond + bond);
    } else if (const MortarLink* mortar = member.structure->mortarOf(bond); mortar != nullptr) {
        const Member& other = memberOf(mortar->instance);
        if (!member.isBroken(bond) && !other.isBroken(mortar->bond)) cross(member, bond, other, mortar->bond, fraction);
    }
}

/// Goes on over mortar, given its halves.
void SupportSpread::cross(const Member& member, std::uint32_t half, const Member& other, std::uint32_t otherHalf,
                          double fraction) {
    const Bond &from = member.structure->graph.bonds[half], &to = other.structure->graph.bonds[otherHalf];
    const double upwards = glm::dot(from.normal, member.up);
    if (upwards <= -kStandsOn) return;  // it would hang
    const std::uint32_t over = other.firstBond + otherHalf;
    if (upwards >= kStandsOn) return reach(other, to.first, 0.0, over);
    const double step = sidewaysOf(from.centroid - member.structure->graph.centres[from.first], member.up) +
                        sidewaysOf(other.structure->graph.centres[to.first] - to.centroid, other.up);
    reach(other, to.first, fraction + other.perMetre * step, over);
}

void SupportSpread::reach(const Member& member, std::uint32_t node, double fraction, std::uint32_t bond) {
    const std::uint32_t index = member.first + node;
    if (!(fraction <= m_limits[index]) || !(fraction < m_fractions[index])) return;
    m_fractions[index] = fraction;
    if (bond != kNone) {
        m_lowerings.push_back({bond, m_lastLowering[index]});
        m_lastLowering[index] = static_cast<std::uint32_t>(m_lowerings.size() - 1);
    }
    m_waiting.add(fraction, index);
}

std::size_t SupportSpread::memberIndex(Id instance) const {
    const auto found = std::ranges::lower_bound(m_members, instance, {}, &Member::instance);
    RUBBLE_ASSERT(found != m_members.end() && found->instance == instance);
    return static_cast<std::size_t>(found - m_members.begin());
}

bool SupportSpread::isMended(Id instance, std::span<const BondDamage> damage) const {
    const std::vector<BondDamage>& known = memberOf(instance).damage;
    for (std::size_t bond = 0; bond < known.size(); ++bond)
        if (known[bond] == kBroken && damage[bond] != kBroken) return true;
    return false;
}

void SupportSpread::setDamage(Id instance, std::span<const BondDamage> damage) {
    const std::size_t index = memberIndex(instance);
    Member& member = m_members[index];
    if (std::ranges::equal(member.damage, damage)) return;
    for (std::uint32_t bond = 0; bond < damage.size(); ++bond) {
        RUBBLE_ASSERT(!member.isBroken(bond) || damage[bond] == kBroken);
        if (damage[bond] == kBroken && !member.isBroken(bond)) m_broken.emplace_back(index, bond);
    }
    member.damage.assign(damage.begin(), damage.end());
}

std::pair<std::uint32_t, std::uint32_t> SupportSpread::beyond(const Member& member, const BondLink& link) const {
    if (link.node != kNone) return {member.first + link.node, member.firstBond + link.bond};
    const MortarLink* mortar = member.structure->mortarOf(link.bond);
    if (mortar == nullptr) return {kNone, kNone};
    const Member& other = memberOf(mortar->instance);
    return {other.first + other.structure->graph.bonds[mortar->bond].first, other.firstBond + mortar->bond};
}

bool SupportSpread::wasLoweredOver(std::uint32_t index, std::uint32_t bond) const {
    for (std::uint32_t k = m_lastLowering[index]; k != kNone; k = m_lowerings[k].before)
        if (m_lowerings[k].bond == bond) return true;
    return false;
}

void SupportSpread::loseIfLoweredOver(std::uint32_t index, std::uint32_t bond) {
    if (!wasLoweredOver(index, bond)) return;
    m_fractions[index] = kUnreached;
    m_lastLowering[index] = kNone;
    m_lost.push_back(index);
}

/// Has what may support a node spread again.
void SupportSpread::reachAnew(std::uint32_t index) {
    const Member& member = memberOfNode(index);
    const std::uint32_t node = index - member.first;
    for (const BondLink& link : member.structure->graph.linksOf(node)) {
        if (member.isBroken(link.bond)) continue;
        const std::uint32_t other = beyond(member, link).first;
        if (other == kNone) {
            reach(member, node, 0.0, member.firstBond + link.bond);
        } else if (m_fractions[other] >= 0.0 && m_fractions[other] < kUnreached) {
            m_waiting.add(m_fractions[other], other);
        }
    }
}

std::vector<InstanceNode> SupportSpread::spread() {
    for (const auto& [index, bond] : m_broken) {
        const Member& member = m_members[index];
        const Bond& one = member.structure->graph.bonds[bond];
        loseIfLoweredOver(member.first + one.first, member.firstBond + bond);
        const auto [other, over] = beyond(member, {one.second, bond});
        if (other != kNone) loseIfLoweredOver(other, over);
    }
    m_broken.clear();
    for (std::size_t k = 0; k < m_lost.size(); ++k) {
        const Member& member = memberOfNode(m_lost[k]);
        for (const BondLink& link : member.structure->graph.linksOf(m_lost[k] - member.first)) {
            const auto [other, over] = beyond(member, link);
            if (other != kNone) loseIfLoweredOver(other, over);
        }
    }
    for (const std::uint32_t index : m_lost) reachAnew(index);
    spreadFromWaiting();
    std::vector<InstanceNode> lost;
    for (const std::uint32_t index : m_lost) {
        const Member& member = memberOfNode(index);
        if (m_fractions[index] == kUnreached) lost.push_back({member.instance, index - member.first});
    }
    m_lost.clear();
    std::ranges::sort(lost);
    return lost;
}

std::vector<double> SupportSpread::fractionsOf(Id instance) const {
    const Member& member = memberOf(instance);
    const auto begin = m_fractions.begin() + member.first;
    std::vector<double> own(begin, begin + member.structure->nodeCount());
    std::ranges::replace(own, kNotHeld, kUnreached);
    return own;
}

}  // namespace rubble
