#include "core/play/breaking/MortarBreaking.h"

#include "core/base/DisjointSets.h"
#include "core/play/state/SessionBodies.h"
#include "core/structure/graph/Islands.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace rubble {
namespace {

/// The structure of an instance's whole, by its index in SessionState::structures; kNone: no bond of it was damaged.
std::uint32_t structureOfInstance(const SessionState& state, Id instance) {
    const auto isIts = [&](const StructureState& one) {
        return one.parent == kNone && state.origins[one.origin].instance == instance;
    };
    const auto found = std::ranges::find_if(state.structures, isIts);
    return found != state.structures.end() ? static_cast<std::uint32_t>(found - state.structures.begin()) : kNone;
}

/// The same, begun if need be.
std::uint32_t begunStructure(SessionParts& parts, Id instance) {
    SessionState& state = parts.state();
    if (const std::uint32_t known = structureOfInstance(state, instance); known != kNone) return known;
    for (PlayBody& body : state.bodies) {
        if (body.role != PlayRole::Instance || state.origins[body.origin].instance != instance) continue;
        structureOf(parts, body);
        return body.structure;
    }
    return kNone;  // it has left the world
}

/// What mortar joins: an island of the nodes of a structure, or all of one that is intact.
struct MortarUnits {
    /// Of one instance that has mortar.
    struct Member {
        const PlayStructure* structure = nullptr;
        const StructureState* state = nullptr;  // null: intact
        std::uint32_t first = 0;                // its first unit
        std::vector<std::uint32_t> unitOfNode;  // relative to that; empty: one for all
    };
    std::map<Id, Member> members;
    std::uint32_t count = 0;
    std::vector<bool> anchoredFlags;  // of each unit: by more than mortar

    std::uint32_t unitOf(const Member& member, std::uint32_t node) const {
        return member.first + (member.unitOfNode.empty() ? 0 : member.unitOfNode[node]);
    }
};

/// Whether a bond of a node holds it by itself.
bool isOwnAnchor(const PlayStructure& structure, const BondLink& link) {
    return link.node == kNone && structure.mortarOf(link.bond) == nullptr;
}

void addIntact(MortarUnits& units, MortarUnits::Member& member) {
    const std::vector<Bond>& bonds = member.structure->graph.bonds;
    bool isAnchored = member.structure->holdsHeaviest;
    for (std::uint32_t bond = 0; bond < bonds.size() && !isAnchored; ++bond)
        isAnchored = bonds[bond].second == kNone && member.structure->mortarOf(bond) == nullptr;
    units.anchoredFlags.push_back(isAnchored);
    ++units.count;
}

void addIslands(const SessionState& session, MortarUnits& units, MortarUnits::Member& member) {
    const PlayStructure& structure = *member.structure;
    const StructureState& state = *member.state;
    std::vector<std::uint32_t> nodes(structure.nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0u);
    const Islands islands = islandsOf(structure.graph, state.damage, nodes);
    member.unitOfNode.resize(nodes.size());
    for (std::uint32_t k = 0; k < islands.count(); ++k) {
        bool isAnchored = false;
        for (const std::uint32_t node : islands[k].nodes) {
            member.unitOfNode[node] = k;
            for (const BondLink& link : structure.graph.linksOf(node))
                isAnchored |= state.damage[link.bond] != kBroken && isOwnAnchor(structure, link);
        }
        if (structure.holdsHeaviest && !isAnchored) {
            const auto number = state.bodyOfNode[islands[k].nodes.front()];
            const auto body = std::ranges::lower_bound(session.bodies, number, {}, &PlayBody::number);
            isAnchored = body != session.bodies.end() && body->number == number && body->isHeld;
        }
        units.anchoredFlags.push_back(isAnchored);
    }
    units.count += islands.count();
}

MortarUnits mortarUnits(const SessionParts& parts, const std::set<Id>& instances) {
    MortarUnits units;
    for (const Id instance : instances) {
        const std::shared_ptr<const PlayStructure>& structure = parts.scene().structures.at(instance);
        MortarUnits::Member& member = units.members[instance];
        member.first = units.count;
        const std::uint32_t begun = structureOfInstance(parts.state(), instance);
        member.state = begun == kNone ? nullptr : &parts.state().structures[begun];
        member.structure = member.state != nullptr ? member.state->structure.get() : structure.get();
        member.state == nullptr ? addIntact(units, member) : addIslands(parts.state(), units, member);
    }
    return units;
}

/// A bond that is mortar.
struct MortarHalf {
    Id instance = 0;
    std::uint32_t bond = 0;
};

bool isBroken(const MortarUnits::Member& member, std::uint32_t bond) {
    return member.state != nullptr && member.state->damage[bond] == kBroken;
}

/// Calls visit(member, half, other member, link) for each half of the mortar between two instances.
template <class Visit>
void forEachHalf(const MortarUnits& units, const Visit& visit) {
    for (const auto& [instance, member] : units.members) {
        for (std::uint32_t bond = member.structure->firstMortar(); bond < member.structure->graph.bondCount(); ++bond) {
            const MortarLink* link = member.structure->mortarOf(bond);
            if (link != nullptr) visit(member, MortarHalf{instance, bond}, units.members.at(link->instance), *link);
        }
    }
}

/// The unbroken halves that hold no longer, ascending.
std::vector<MortarHalf> looseHalves(const MortarUnits& units) {
    DisjointSets sets(units.count);
    forEachHalf(units, [&](const auto& member, const MortarHalf& half, const auto& other, const MortarLink& link) {
        if (isBroken(member, half.bond) || isBroken(other, link.bond)) return;
        sets.merge(units.unitOf(member, member.structure->graph.bonds[half.bond].first),
                   units.unitOf(other, other.structure->graph.bonds[link.bond].first));
    });
    std::vector<bool> isAnchored(units.count);  // by root
    for (std::uint32_t unit = 0; unit < units.count; ++unit) {
        if (units.anchoredFlags[unit]) isAnchored[sets.rootOf(unit)] = true;
    }
    std::vector<MortarHalf> loose;
    forEachHalf(units, [&](const auto& member, const MortarHalf& half, const auto& other, const MortarLink& link) {
        if (isBroken(member, half.bond)) return;
        const std::uint32_t unit = units.unitOf(member, member.structure->graph.bonds[half.bond].first);
        if (isBroken(other, link.bond) || !isAnchored[sets.rootOf(unit)]) loose.push_back(half);
    });
    return loose;
}

}  // namespace

void shareMortarDamage(SessionParts& parts, std::uint32_t structure) {
    const std::shared_ptr<const PlayStructure> own = parts.state().structures[structure].structure;
    for (std::uint32_t bond = own->firstMortar(); bond < own->graph.bondCount(); ++bond) {
        const BondDamage damage = parts.state().structures[structure].damage[bond];
        const MortarLink* link = own->mortarOf(bond);
        if (link == nullptr || damage == kIntact || damage == kBroken) continue;
        const std::uint32_t other = begunStructure(parts, link->instance);
        if (other == kNone) continue;
        BondDamage& there = parts.state().structures[other].damage[link->bond];
        there = std::max(there, damage);
    }
}

std::vector<BrokenBonds> brokenMortar(SessionParts& parts, const std::set<Id>& changed) {
    const std::set<Id> instances = joinedInstances(parts.scene().structures, changed);
    std::map<std::uint32_t, BrokenBonds> broken;  // by body
    for (const MortarHalf& half : looseHalves(mortarUnits(parts, instances))) {
        const std::uint32_t index = begunStructure(parts, half.instance);
        if (index == kNone) continue;
        StructureState& state = parts.state().structures[index];
        state.damage[half.bond] = kBroken;
        const std::uint32_t number = state.bodyOfNode[state.structure->graph.bonds[half.bond].first];
        const PlayBody* const body = findBody(parts.state(), number);
        if (body == nullptr) continue;
        BrokenBonds& one = broken[number];
        one.body = number;
        one.point = parts.world().state(body->body).centre;
        one.bonds.push_back(half.bond);
    }
    std::vector<BrokenBonds> bodies;
    for (auto& [number, one] : broken) bodies.push_back(std::move(one));
    return bodies;
}

}  // namespace rubble
