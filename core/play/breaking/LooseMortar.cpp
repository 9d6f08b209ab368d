#include "core/play/breaking/LooseMortar.h"

#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rubble {
namespace {

/// Whether a bond is broken in a structure; null: it is intact.
bool isBroken(const StructureState* state, std::uint32_t bond) {
    return state != nullptr && state->damage[bond] == kBroken;
}

/// Searches for anchors from body to body, over mortar.
class AnchorSearch {
public:
    AnchorSearch(const SessionParts& parts, const BegunStructures& begun) : m_parts(parts), m_begun(begun) {}

    /// Looks at the mortar of an instance at which something changed.
    void examine(Id instance) {
        const Member& member = memberOf(instance);
        const PlayStructure& structure = *member.structure;
        for (std::uint32_t bond = structure.firstMortar(); bond < structure.graph.bondCount(); ++bond) {
            const MortarLink* link = structure.mortarOf(bond);
            if (link == nullptr) continue;
            const bool isOtherBroken = isBroken(m_begun.find(link->instance), link->bond);
            if (!isBroken(member.state, bond)) {
                if (isOtherBroken) m_loose.insert({instance, bond});
                search(unitOf(member, bond));
            } else if (!isOtherBroken) {
                m_loose.insert({link->instance, link->bond});
                search(unitOf(memberOf(link->instance), link->bond));
            }
        }
    }

    LooseMortar loose() const { return {{m_loose.begin(), m_loose.end()}, m_members.size()}; }

private:
    enum class Hold { Unknown, Anchored, Loose };
    /// A body that mortar joins: an island of the nodes of a structure.
    struct Unit {
        Id instance = 0;
        bool isAnchored = false;            // by more than mortar
        Hold hold = Hold::Unknown;          // by anything
        std::vector<std::uint32_t> halves;  // unbroken
    };
    /// An instance that mortar joins.
    struct Member {
        const PlayStructure* structure = nullptr;
        const StructureState* state = nullptr;  // null: intact
        // Of nodes with bonds to anchors, by the number of their body, or alone.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> units;
    };

    static std::pair<std::uint32_t, std::uint32_t> bodyOf(const Member& member, std::uint32_t node) {
        if (member.state == nullptr) return {0, 0};  // all are one
        const std::uint32_t number = member.state->bodyOfNode[node];
        return number != kNone ? std::pair{number, 0u} : std::pair{kNone, node};
    }
    std::uint32_t unitOf(const Member& member, std::uint32_t bond) const {
        return member.units.at(bodyOf(member, member.structure->graph.bonds[bond].first));
    }

    const Member& memberOf(Id instance) {
        const auto [found, isNew] = m_members.try_emplace(instance);
        if (isNew) addUnits(instance, found->second);
        return found->second;
    }

    void addUnits(Id instance, Member& member) {
        member.state = m_begun.find(instance);
        member.structure =
            member.state != nullptr ? member.state->structure.get() : m_parts.scene().structures.at(instance).get();
        const PlayStructure& structure = *member.structure;
        const std::vector<Bond>& bonds = structure.graph.bonds;
        for (std::uint32_t bond = structure.graph.bondCount(); bond-- > 0 && bonds[bond].second == kNone;) {
            if (isBroken(member.state, bond)) continue;
            const auto body = bodyOf(member, bonds[bond].first);
            const auto [found, isNew] = member.units.emplace(body, static_cast<std::uint32_t>(m_units.size()));
            if (isNew) m_units.push_back({.instance = instance, .isAnchored = isHeaviest(member, body.first)});
            Unit& unit = m_units[found->second];
            structure.mortarOf(bond) != nullptr ? unit.halves.push_back(bond) : void(unit.isAnchored = true);
        }
    }

    /// Whether a body is held since it is the heaviest of what is fixed.
    bool isHeaviest(const Member& member, std::uint32_t number) const {
        if (!member.structure->holdsHeaviest || member.state == nullptr) return member.structure->holdsHeaviest;
        const PlayBody* body = findBody(m_parts.state(), number);
        return body != nullptr && body->isHeld;
    }

    /// Finds how a unit is held, and collects the mortar of all that it is connected to if by nothing.
    void search(std::uint32_t start) {
        if (m_units[start].hold != Hold::Unknown) return;
        std::vector<std::uint32_t> reached{start};
        m_units[start].hold = Hold::Loose;
        bool isAnchored = false;
        for (std::size_t next = 0; next < reached.size() && !isAnchored; ++next)
            isAnchored = m_units[reached[next]].isAnchored || reachNeighbours(reached[next], reached);
        for (const std::uint32_t unit : reached) {
            m_units[unit].hold = isAnchored ? Hold::Anchored : Hold::Loose;
            if (isAnchored) continue;
            for (const std::uint32_t half : m_units[unit].halves) m_loose.insert({m_units[unit].instance, half});
        }
    }

    /// Adds the units that mortar joins with one. True if one of them is known to be held.
    bool reachNeighbours(std::uint32_t unit, std::vector<std::uint32_t>& reached) {
        const Id instance = m_units[unit].instance;
        const PlayStructure& structure = *m_members.at(instance).structure;
        for (const std::uint32_t half : std::vector<std::uint32_t>(m_units[unit].halves)) {
            const MortarLink& link = *structure.mortarOf(half);
            if (isBroken(m_begun.find(link.instance), link.bond)) continue;
            const std::uint32_t other = unitOf(memberOf(link.instance), link.bond);
            if (m_units[other].hold == Hold::Anchored) return true;
            if (m_units[other].hold == Hold::Loose) continue;  // reached already
            m_units[other].hold = Hold::Loose;
            reached.push_back(other);
        }
        return false;
    }

    const SessionParts& m_parts;
    const BegunStructures& m_begun;
    std::map<Id, Member> m_members;
    std::vector<Unit> m_units;
    std::set<MortarHalf> m_loose;
};

}  // namespace

LooseMortar looseMortar(const SessionParts& parts, const BegunStructures& begun, const std::set<Id>& changed) {
    AnchorSearch search(parts, begun);
    for (const Id instance : changed) {
        const auto structure = parts.scene().structures.find(instance);
        if (structure != parts.scene().structures.end() && structure->second->joined != nullptr)
            search.examine(instance);
    }
    return search.loose();
}

}  // namespace rubble
