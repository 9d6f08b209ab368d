#include "core/play/breaking/MortarBreaking.h"

#include "core/play/breaking/LooseMortar.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <map>

namespace rubble {
namespace {

/// The structure of an instance's whole, by its index in SessionState::structures, begun if need be.
std::uint32_t begunStructure(SessionParts& parts, Id instance) {
    SessionState& state = parts.state();
    const auto isIts = [&](const StructureState& one) {
        return one.parent == kNone && state.origins[one.origin].instance == instance;
    };
    const auto known = std::ranges::find_if(state.structures, isIts);
    if (known != state.structures.end()) return static_cast<std::uint32_t>(known - state.structures.begin());
    for (PlayBody& body : state.bodies) {
        if (body.role != PlayRole::Instance || state.origins[body.origin].instance != instance) continue;
        structureOf(parts, body);
        return body.structure;
    }
    return kNone;  // it has left the world
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
    std::map<std::uint32_t, BrokenBonds> broken;  // by body
    for (const MortarHalf& half : looseMortar(parts, BegunStructures(parts.state()), changed).halves) {
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
