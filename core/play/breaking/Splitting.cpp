#include "core/play/breaking/Splitting.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/physics/world/Split.h"
#include "core/play/breaking/Collapsing.h"
#include "core/play/breaking/MortarBreaking.h"
#include "core/play/breaking/MovingMass.h"
#include "core/play/scene/PlayBodyShape.h"
#include "core/play/state/InputDiagnostics.h"
#include "core/play/state/SessionBodies.h"
#include "core/structure/graph/Islands.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

namespace rubble {
namespace {

/// A set of nodes that is one body after a split.
struct PartOfBody {
    std::vector<std::uint32_t> nodes;  // ascending
    bool isHeld = false;
    double volume = 0.0;  // m³
};

double volumeOf(const PlayStructure& structure, std::span<const std::uint32_t> nodes) {
    double volume = 0.0;
    for (const std::uint32_t node : nodes) volume += structure.volumes[node];
    return volume;
}

/// The bonds of a body that broke.
struct Breakage {
    std::vector<std::uint32_t> bonds;
    bool isAll = true;  // its nodes were one island before these broke
};

/// The islands of nodes of a body.
Islands islandsOfNodes(const StructureState& state, std::span<const std::uint32_t> nodes, const Breakage& broken) {
    const BondGraph& graph = state.structure->graph;
    return broken.isAll ? islandsAfter(graph, state.damage, nodes, broken.bonds)
                        : islandsOf(graph, state.damage, nodes);
}

/// The islands of a body as its parts, the heaviest first, then by lowest node. Only what was held can be held.
std::vector<PartOfBody> partsOfBody(const StructureState& state, const Islands& islands, bool wasHeld) {
    std::vector<PartOfBody> made;
    for (std::uint32_t k = 0; k < islands.count(); ++k) {
        const Island island = islands[k];
        made.push_back({{island.nodes.begin(), island.nodes.end()},
                        wasHeld && island.isAnchored,
                        volumeOf(*state.structure, island.nodes)});
    }
    const auto heaviest = std::ranges::max_element(made, {}, &PartOfBody::volume);
    if (wasHeld && state.structure->holdsHeaviest) heaviest->isHeld = true;
    std::rotate(made.begin(), heaviest, heaviest + 1);
    return made;
}

/// Lets islands of a body that are too small fall apart.
void crumble(StructureState& state, const Islands& islands, std::vector<std::uint32_t>& broken) {
    const std::uint32_t least = state.structure->minimumIsland;
    if (islands.count() == 1) return;
    for (std::uint32_t k = 0; k < islands.count(); ++k) {
        const Island island = islands[k];
        if (island.isAnchored || island.nodes.size() < 2 || island.nodes.size() >= least) continue;
        const auto canBreak = [&](const BondLink& link) {
            return std::isfinite(state.structure->capacities[link.bond]);
        };
        breakBonds(state, island.nodes, canBreak, broken);
    }
}

/// What a body falls apart into: its islands, after those that are too small fell apart, if anything broke.
std::vector<PartOfBody> crumbledParts(StructureState& state, std::span<const std::uint32_t> nodes, bool wasHeld,
                                      Breakage& broken) {
    Islands islands = islandsOfNodes(state, nodes, broken);
    const std::size_t count = broken.bonds.size();
    if (count > 0) crumble(state, islands, broken.bonds);
    if (broken.bonds.size() > count) islands = islandsOfNodes(state, nodes, broken);
    return partsOfBody(state, islands, wasHeld);
}

/// The body that a part of another one is, given that one without its nodes, which may be many. A fragment alone is no
/// longer one of a structure.
PlayBody bodyOfPart(const SessionParts& parts, const PlayBody& withoutNodes, const PartOfBody& part) {
    const StructureState& state = parts.state().structures[withoutNodes.structure];
    PlayBody made = withoutNodes;
    made.isHeld = part.isHeld;
    made.collapseStep = PlayBody::kNever;
    made.nodes = part.nodes;
    if (part.nodes.size() > 1 || part.isHeld) return made;
    made.role = PlayRole::Debris;
    made.fragment = state.structure->fragmentOf(part.nodes.front());
    made.structure = kNone;
    made.nodes.clear();
    return made;
}

/// The hulls of the shape of a body, by the first of each of its nodes; none if its whole stands for them.
std::vector<std::uint32_t> firstHullsOf(const PlayStructure& structure, const PlayBody& body) {
    std::vector<std::uint32_t> first(structure.nodeCount(), kNone);
    if (!isPartial(body)) return first;
    const PlayFracture& fracture = structure.fracture();
    std::uint32_t next = 0;
    for (const std::uint32_t node : body.nodes) {
        first[node] = next;
        next += fracture.hullCount(node);
    }
    return first;
}

/// For each hull of a part, the hull of the body that it was; kNone: a new one.
std::vector<std::uint32_t> hullsBefore(const PlayStructure& structure, const PartOfBody& part, std::size_t count,
                                       std::span<const std::uint32_t> firstHulls) {
    std::vector<std::uint32_t> before(count);
    std::iota(before.begin(), before.end(), 0u);
    if (part.nodes.size() == structure.nodeCount()) return before;  // the hulls of the whole, which it keeps
    const PlayFracture& fracture = structure.fracture();
    std::size_t hull = 0;
    for (const std::uint32_t node : part.nodes) {
        for (std::uint32_t k = 0; k < fracture.hullCount(node); ++k) {
            before[hull++] = firstHulls[node] == kNone ? kNone : firstHulls[node] + k;
        }
    }
    return before;
}

/// A part of a body as the world splits it.
SplitPart splitPart(const SessionParts& parts, const PlayBody& before, const PlayBody& after, const PartOfBody& part,
                    std::span<const std::uint32_t> firstHulls) {
    const PlayStructure& structure = *parts.state().structures[before.structure].structure;
    SplitPart made{.shape = shapeOf(after),
                   .offset = frameOf(after) - frameOf(before),
                   .kind = part.isHeld ? BodyKind::Static : BodyKind::Dynamic,
                   .material = bodyMaterial(parts, *after.asset, after.fragment, after.role),
                   .tag = after.number};
    made.hulls = hullsBefore(structure, part, made.shape->hulls.size(), firstHulls);
    if (made.kind == BodyKind::Static) return made;
    const BodyState state = parts.world().state(before.body);
    const Vec3 centre = state.pose.position + state.pose.orientation * (made.offset + made.shape->mass.centre);
    made.velocity = limitedVelocity(state.velocity + glm::cross(state.angularVelocity, centre - state.centre));
    made.angularVelocity = limitedVelocity(spinOfPart(*made.shape, state.pose.orientation, state.angularVelocity));
    return made;
}

/// Adds the energies of a body and of the parts that replaced it.
void auditSplit(SessionParts& parts, std::uint32_t number, double before, std::span<const SplitPart> made,
                std::span<const BodyId> bodies) {
    EnergyEntry entry{.change = EnergyChange::Split, .body = number, .before = before};
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        entry.after += kineticEnergy(parts.world(), bodies[k]);
        if (made[k].kind != BodyKind::Dynamic) continue;
        const double weight = parts.world().mass(bodies[k]) * glm::length(parts.world().gravity());
        const double distance = glm::length(parts.world().state(bodies[k]).centre);
        entry.rounding += weight * kPositionRounding * std::max(1.0, distance / kRoundedDistance);
    }
    parts.state().events.energy.push_back(entry);
}

/// Replaces a body by the bodies of its parts. Adds the numbers of those that came off.
void replaceBody(SessionParts& parts, const PlayBody& before, std::span<const PartOfBody> islands,
                 std::vector<std::uint32_t>& freed) {
    SessionState& state = parts.state();
    StructureState& structure = state.structures[before.structure];
    std::vector<PlayBody> after;
    std::vector<SplitPart> made;
    const std::vector<std::uint32_t> firstHulls = firstHullsOf(*structure.structure, before);
    PlayBody withoutNodes = before;
    withoutNodes.nodes = {};
    for (const PartOfBody& island : islands) {
        after.push_back(bodyOfPart(parts, withoutNodes, island));
        PlayBody& body = after.back();
        if (after.size() > 1) {
            body.role = PlayRole::Debris;
            body.isUnbreakable = false;
            body.number = state.nextNumber++;
            body.born = state.step;
            body.restCentre.reset();
        } else {
            body.collapseStep = before.collapseStep;
            if (before.isHeld && !body.isHeld) body.born = state.step;  // it is debris from now on
        }
        made.push_back(splitPart(parts, before, body, island, firstHulls));
        for (const std::uint32_t node : island.nodes) {
            structure.bodyOfNode[node] = body.nodes.empty() ? kNone : body.number;
        }
    }
    const double energy = kineticEnergy(parts.world(), before.body);
    const Result<std::vector<BodyId>> bodies = parts.world().split(before.body, made);
    RUBBLE_ASSERT(bodies.hasValue());  // the fragments can be bodies, and their speeds are limited
    auditSplit(parts, before.number, energy, made, *bodies);
    for (std::size_t k = 0; k < after.size(); ++k) {
        after[k].body = (*bodies)[k];
        planCollapse(parts, after[k]);
        if (k == 0) {
            *findBody(state, before.number) = after[k];
        } else {
            state.bodies.push_back(after[k]);
            state.events.born.push_back(after[k]);
        }
        const bool wasFree = k == 0 && !before.isHeld;
        if (!after[k].isHeld && !wasFree) freed.push_back(after[k].number);
    }
}

/// The bodies that an impactor pushes out of a held body, as one mass along a direction.
struct Plug {
    std::vector<BodyId> bodies;
    MovingMass mass;
};

Plug plugOf(const SessionParts& parts, const PlaySplit& split, double radius) {
    Plug plug;
    double mass = 0.0;
    Vec3 momentum(0.0);
    for (const std::uint32_t number : split.freed) {
        const BodyId body = findBody(parts.state(), number)->body;
        if (parts.world().kind(body) != BodyKind::Dynamic) continue;
        if (distanceToBody(parts.world(), body, split.point) > radius) continue;
        plug.bodies.push_back(body);
        mass += parts.world().mass(body);
        momentum += parts.world().mass(body) * parts.world().state(body).velocity;
    }
    if (mass > 0.0) plug.mass = {.inverseMass = 1.0 / mass, .centre = split.point, .velocity = momentum / mass};
    return plug;
}

void pushPlug(SessionParts& parts, const PlaySplit& split, double restitution) {
    const PlayBody* const impactor = findBody(parts.state(), split.impactorNumber);
    if (impactor == nullptr || !split.body.isHeld || parts.world().kind(impactor->body) != BodyKind::Dynamic) return;
    const Plug plug = plugOf(parts, split, static_cast<double>(parts.world().shape(impactor->body).boundingRadius));
    if (plug.bodies.empty()) return;
    const MovingMass pushing = movingMass(parts.world(), impactor->body);
    const Vec3 impulse = stoppingImpulse(pushing, plug.mass, split.point, split.normal, restitution) * split.normal;
    EnergyEntry entry{.change = EnergyChange::Bonds, .body = split.body.number, .before = pushing.kineticEnergy()};
    const std::string cause = "The hit on " + quotedName(nameOf(split.body, parts.state().origins[split.body.origin]));
    if (!applyImpulse(parts, impactor->body, -impulse, split.point, cause)) return;
    entry.after = kineticEnergy(parts.world(), impactor->body);
    for (const BodyId body : plug.bodies) {
        entry.before += kineticEnergy(parts.world(), body);
        const Vec3 part = parts.world().mass(body) * plug.mass.inverseMass * impulse;
        applyImpulse(parts, body, part, parts.world().state(body).centre, cause);
        entry.after += kineticEnergy(parts.world(), body);
    }
    parts.state().events.energy.push_back(entry);
}

/// Has the clusters of a body, and of all that it falls apart into, hold deeper levels than that at which it broke.
void holdDeeperLevels(const SessionParts& parts, PlayBody& body, ClusterLevel level) {
    constexpr double kRounding = 1e-9;  // s
    const bool isHeld = timeOf(parts.state(), parts.settings().dt) < body.heldUntil;
    body.heldLevel = isHeld ? std::min(body.heldLevel, level) : level;
    body.heldUntil = timeOf(parts.state(), parts.settings().dt) + kLevelTime - kRounding;
}

/// Splits a body whose bonds broke, and reports it. True if any body came free.
bool splitBody(SessionParts& parts, BrokenBonds broken) {
    PlayBody& body = *findBody(parts.state(), broken.body);
    StructureState& state = structureOf(parts, body);
    holdDeeperLevels(parts, body, broken.level);
    PlaySplit split{.step = parts.state().step + 1,
                    .body = body,
                    .impactorNumber = broken.impactor,
                    .impulse = broken.impulse,
                    .approachSpeed = broken.speed,
                    .point = broken.point,
                    .normal = broken.normal,
                    .level = broken.level};
    Breakage breakage{.bonds = std::move(broken.bonds)};
    breakage.isAll = !breakage.bonds.empty();
    if (state.structure->collapseDelay == 0.0) {
        HeldClusters held = heldClusters(parts, body);
        held.breaking = std::min(held.breaking, broken.level);
        breakUnsupported(parts, body, body.nodes, held, state, breakage.bonds);
    }
    const std::vector<PartOfBody> islands = crumbledParts(state, body.nodes, body.isHeld, breakage);
    const bool isChanged = islands.size() > 1 || islands.front().isHeld != body.isHeld;
    if (isChanged) {
        replaceBody(parts, split.body, islands, split.freed);
        pushPlug(parts, split, broken.restitution);
    } else {
        planCollapse(parts, body);
    }
    split.bonds = static_cast<std::uint32_t>(breakage.bonds.size());
    for (const std::uint32_t bond : breakage.bonds) {
        const Bond& one = parts.state().structures[split.body.structure].structure->graph.bonds[bond];
        split.area += (one.second == kNone ? 1.0 : 2.0) * one.area;
    }
    parts.state().events.splits.push_back(std::move(split));
    return isChanged;
}

/// The bodies none of whose bonds broke yet, but with islands that no bond with a strength joins: beside a gap,
/// or where bonds have none.
std::vector<BrokenBonds> unjoinedBodies(SessionParts& parts) {
    std::vector<BrokenBonds> unjoined;
    if (!parts.scene().hasUnjoined) return unjoined;
    for (PlayBody& body : parts.state().bodies) {
        if (body.structure != kNone || body.bondedFracture() == nullptr) continue;
        if (structureIn(parts.scene(), parts.state().origins[body.origin], body.fragment)->isJoined) continue;
        structureOf(parts, body);
        unjoined.push_back({.body = body.number, .point = parts.world().state(body.body).centre});
    }
    return unjoined;
}

}  // namespace

void removeNodes(SessionParts& parts, std::uint32_t number, std::span<const std::uint32_t> nodes) {
    PlayBody& body = *findBody(parts.state(), number);
    StructureState& state = structureOf(parts, body);
    Breakage broken;
    breakBonds(
        state, nodes, [](const BondLink&) { return true; }, broken.bonds);
    for (const std::uint32_t node : nodes) state.bodyOfNode[node] = kNone;
    std::vector<std::uint32_t> kept;
    std::ranges::set_difference(body.nodes, nodes, std::back_inserter(kept));
    if (kept.empty()) {
        removeFromWorld(parts, number);
        eraseRemovedBodies(parts.state());
        return;
    }
    breakUnsupported(parts, body, kept, heldClusters(parts, body), state, broken.bonds);
    std::vector<std::uint32_t> freed;
    replaceBody(parts, PlayBody(body), crumbledParts(state, kept, body.isHeld, broken), freed);
}

bool splitBodies(SessionParts& parts, std::vector<BrokenBonds> broken) {
    bool isAnyFree = false;
    while (!broken.empty()) {
        std::set<Id> instances;
        for (const BrokenBonds& one : broken)
            instances.insert(parts.state().origins[findBody(parts.state(), one.body)->origin].instance);
        for (BrokenBonds& one : broken) isAnyFree |= splitBody(parts, std::move(one));
        broken = brokenMortar(parts, instances);
        std::ranges::move(unjoinedBodies(parts), std::back_inserter(broken));
    }
    return isAnyFree;
}

void splitUnjoined(SessionParts& parts) { splitBodies(parts, unjoinedBodies(parts)); }

}  // namespace rubble
