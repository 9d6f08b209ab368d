#include "core/play/breaking/PartRemoval.h"

#include "core/play/breaking/MortarBreaking.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

/// The numbers of the bodies of an instance.
std::vector<std::uint32_t> bodiesOf(const SessionState& state, Id instance) {
    std::vector<std::uint32_t> numbers;
    for (const PlayBody& body : state.bodies) {
        if (state.origins[body.origin].instance == instance) numbers.push_back(body.number);
    }
    return numbers;
}

}  // namespace

void breakMortarOf(SessionParts& parts, std::uint32_t number) {
    PlayBody& body = *findBody(parts.state(), number);
    if (body.bondedFracture() == nullptr) return;
    StructureState& state = structureOf(parts, body);
    const BondGraph& graph = state.structure->graph;
    for (std::uint32_t bond = state.structure->firstMortar(); bond < graph.bondCount(); ++bond)
        if (state.bodyOfNode[graph.bonds[bond].first] == number) state.damage[bond] = kBroken;
}

void removeInstance(SessionParts& parts, Id instance) {
    const std::vector<std::uint32_t> numbers = bodiesOf(parts.state(), instance);
    for (const std::uint32_t number : numbers) {
        parts.state().events.taken.push_back(removalOf(parts, *findBody(parts.state(), number), RemovalReason::Input));
        breakMortarOf(parts, number);
        for (StructureState& structure : parts.state().structures)
            std::ranges::replace(structure.bodyOfNode, number, kNone);
        removeFromWorld(parts, number);
    }
    eraseRemovedBodies(parts.state());
    splitBodies(parts, brokenMortar(parts, {instance}));
}

void removeFragments(SessionParts& parts, Id instance, std::vector<std::uint32_t> fragments) {
    std::ranges::sort(fragments);
    for (const std::uint32_t number : bodiesOf(parts.state(), instance)) {
        const PlayBody& body = *findBody(parts.state(), number);
        std::vector<std::uint32_t> lost;
        std::ranges::set_intersection(bondedFragments(body), fragments, std::back_inserter(lost));
        const bool isBodyAlone = lost.empty() && std::ranges::binary_search(fragments, body.fragment);
        if (lost.empty() && !isBodyAlone) continue;
        parts.state().events.taken.push_back(removalOf(parts, body, RemovalReason::Input));
        parts.state().events.taken.back().fragments = lost;
        if (!lost.empty()) {
            for (std::uint32_t& fragment : lost) fragment -= body.bondedFracture()->first;
            removeNodes(parts, number, lost);
        } else {
            removeFromWorld(parts, number);
            eraseRemovedBodies(parts.state());
        }
    }
    splitBodies(parts, brokenMortar(parts, {instance}));
}

}  // namespace rubble
