#include "core/play/breaking/BrokenBonds.h"

#include "core/base/Assert.h"

#include <algorithm>

namespace rubble {

StructureState& structureOf(SessionParts& parts, PlayBody& body) {
    std::vector<StructureState>& structures = parts.state().structures;
    if (body.structure != kNone) return structures[body.structure];
    RUBBLE_ASSERT(body.bondedFracture() != nullptr);
    StructureState begun{.origin = body.origin,
                         .parent = body.fragment,
                         .structure = structureIn(parts.scene(), parts.state().origins[body.origin], body.fragment)};
    begun.damage = begun.structure->initialDamage;
    begun.bodyOfNode.assign(begun.structure->nodeCount(), body.number);
    body.structure = static_cast<std::uint32_t>(structures.size());
    body.nodes = begun.structure->allNodes();
    structures.push_back(std::move(begun));
    return structures.back();
}

HeldClusters clustersOf(const StructureState& state, const PlayBody& body) {
    const PlayStructure& structure = *state.structure;
    return {structure.clusterLevels,
            breakingLevel(structure.graph, structure.capacities, structure.clusterLevels, state.damage, body.nodes)};
}

HeldClusters heldClusters(const SessionParts& parts, const PlayBody& body) {
    HeldClusters held = clustersOf(parts.state().structures[body.structure], body);
    if (timeOf(parts.state(), parts.settings().dt) < body.heldUntil)
        held.breaking = std::min(held.breaking, body.heldLevel);
    return held;
}

}  // namespace rubble
