#include "core/play/breaking/Collapsing.h"

#include "core/play/breaking/MortarSupport.h"
#include "core/structure/graph/Support.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rubble {
namespace {

/// Nodes of a held body that lose their bonds, since they have lost their support.
struct Unsupported {
    std::vector<std::uint32_t> nodes;  // ascending
    HeldClusters held;                 // whose bonds they keep
};

/// Of nodes without support, those that lose their bonds: clusters that hold have support where one of their nodes
/// has. `nodes`: all of the body.
Unsupported losingNodes(const StructureState& state, std::span<const std::uint32_t> nodes, const HeldClusters& held,
                        std::span<const std::uint32_t> beyond) {
    return {wholeClusters(beyond, state.structure->graph, held, state.damage, nodes), held};
}

/// Those of a held body; nothing of one that mortar joins, see MortarSupport.h.
Unsupported unsupportedOf(const SessionParts& parts, const PlayBody& body, const StructureState& state,
                          std::span<const std::uint32_t> nodes, const HeldClusters& held) {
    const PlayStructure& structure = *state.structure;
    const Vec3 gravity = parts.world().gravity();
    if (!body.isHeld || !structure.hasSpan() || !structure.mortar.empty() || gravity == Vec3(0.0)) return {};
    const Instance& instance = *findInstance(parts.scene().project, parts.state().origins[body.origin].instance);
    const Vec3 up = upIn(poseOf(instance), gravity);  // what is held stays where it was placed
    const std::vector<double> limits = supportLimitsOf(structure, up);
    return losingNodes(state, nodes, held, unsupportedNodes(structure.graph, state.damage, nodes, limits, up));
}

/// Breaks all bonds of what has no support but those of its clusters: in one piece it would jam between what stands.
void breakNodes(StructureState& state, const Unsupported& unsupported, std::vector<std::uint32_t>& broken) {
    const auto canBreak = [&](const BondLink& link) {
        return std::isfinite(state.structure->capacities[link.bond]) && !unsupported.held.holds(link.bond);
    };
    breakBonds(state, unsupported.nodes, canBreak, broken);
}

std::uint64_t collapseStepOf(const SessionParts& parts, const PlayStructure& structure) {
    const double steps = std::ceil(structure.collapseDelay / parts.settings().dt - 1e-6);
    return parts.state().step + 1 + static_cast<std::uint64_t>(std::max(1.0, steps));
}

}  // namespace

void breakUnsupported(const SessionParts& parts, const PlayBody& body, std::span<const std::uint32_t> nodes,
                      const HeldClusters& held, StructureState& state, std::vector<std::uint32_t>& broken) {
    breakNodes(state, unsupportedOf(parts, body, state, nodes, held), broken);
}

void planCollapse(const SessionParts& parts, PlayBody& body) {
    if (!body.isHeld) {
        body.collapseStep = PlayBody::kNever;
        return;
    }
    const StructureState& state = parts.state().structures[body.structure];
    if (!state.structure->mortar.empty()) return;  // planMortarCollapse() does
    if (unsupportedOf(parts, body, state, body.nodes, clustersOf(state, body)).nodes.empty()) {
        body.collapseStep = PlayBody::kNever;
    } else if (body.collapseStep == PlayBody::kNever) {
        body.collapseStep = collapseStepOf(parts, *state.structure);
    }
}

void planMortarCollapse(SessionParts& parts, const std::set<Id>& changed) {
    const JoinedGroups groups = joinedGroups(parts.scene().structures, changed);
    if (groups.empty()) return;
    const UnsupportedNodes unsupported = unsupportedByMortar(parts, groups);
    const auto isChanged = [&](const PlayStructure& structure) {
        return structure.joined != nullptr && groups.contains(structure.joined->front());
    };
    for (PlayBody& body : parts.state().bodies) {
        if (!body.isHeld) continue;
        bool doLose = false;
        if (const auto found = unsupported.find(body.number); found != unsupported.end()) {
            const StructureState& state = structureOf(parts, body);
            doLose = !losingNodes(state, body.nodes, clustersOf(state, body), found->second).nodes.empty();
        }
        if (doLose) {
            const PlayStructure& structure = *parts.state().structures[body.structure].structure;
            if (body.collapseStep == PlayBody::kNever) body.collapseStep = collapseStepOf(parts, structure);
        } else if (body.structure != kNone && isChanged(*parts.state().structures[body.structure].structure)) {
            body.collapseStep = PlayBody::kNever;
        }
    }
}

std::vector<BrokenBonds> brokenByCollapse(SessionParts& parts) {
    const auto isDue = [&](const PlayBody& body) { return body.collapseStep <= parts.state().step + 1; };
    std::set<Id> instances;
    for (const PlayBody& body : parts.state().bodies)
        if (isDue(body)) instances.insert(parts.state().origins[body.origin].instance);
    if (instances.empty()) return {};
    std::vector<BrokenBonds> broken;
    std::optional<UnsupportedNodes> byMortar;
    for (PlayBody& body : parts.state().bodies) {
        if (!isDue(body)) continue;
        body.collapseStep = PlayBody::kNever;
        StructureState& state = parts.state().structures[body.structure];
        const HeldClusters held = heldClusters(parts, body);
        BrokenBonds one{.body = body.number, .point = parts.world().state(body.body).centre, .level = held.breaking};
        if (state.structure->mortar.empty()) {
            breakUnsupported(parts, body, body.nodes, held, state, one.bonds);
        } else {
            if (!byMortar) byMortar = unsupportedByMortar(parts, joinedGroups(parts.scene().structures, instances));
            breakNodes(state, losingNodes(state, body.nodes, held, (*byMortar)[body.number]), one.bonds);
        }
        if (!one.bonds.empty()) broken.push_back(std::move(one));
    }
    return broken;
}

}  // namespace rubble
