#include "core/play/breaking/BondBreaking.h"

#include "core/base/MessageText.h"
#include "core/play/breaking/MortarBreaking.h"
#include "core/play/breaking/MovingMass.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/state/InputDiagnostics.h"
#include "core/play/state/SessionBodies.h"
#include "core/structure/rule/SimpleRule.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

/// What one body does to another in a step, at all their hulls together.
struct BondStrike {
    std::uint32_t body = 0;      // number of the one that is hit
    std::uint32_t impactor = 0;  // number of the other
    Impact impact;               // the strongest
    std::vector<Vec3> points;    // m, in the world: of all
};

/// The hits on bodies with bonds, by body, then impactor.
std::vector<BondStrike> strikesOf(const SessionParts& parts, std::span<const Impact> impacts) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, BondStrike> strikes;
    for (const Impact& impact : impacts) {
        for (const bool isFirst : {true, false}) {
            const BodyId hit = isFirst ? impact.first : impact.second;
            const auto number = static_cast<std::uint32_t>(parts.world().tag(hit));
            const PlayBody* const body = findBody(parts.state(), number);
            if (body->bondedFracture() == nullptr) continue;
            const auto other = static_cast<std::uint32_t>(parts.world().tag(isFirst ? impact.second : impact.first));
            BondStrike& strike =
                strikes.try_emplace({number, other}, BondStrike{number, other, impact, {}}).first->second;
            if (impact.impulse() > strike.impact.impulse()) strike.impact = impact;
            strike.points.push_back(impact.point);
        }
    }
    std::vector<BondStrike> all;
    for (auto& [bodies, strike] : strikes) all.push_back(std::move(strike));
    return all;
}

/// Reports a hit that changes no bond as if the weakest one got all of it.
void tellWeakHit(SessionParts& parts, const PlayStructure& structure, const BondStrike& strike) {
    const double breaking = structure.leastImpulse / structure.rule.damageFrom;
    parts.state().events.impacts.push_back({strike.body, strike.impact.impulse(), breaking, strike.impact.point});
}

/// Points in the world, in the frame of a body's structure.
std::vector<Vec3> inStructure(const SessionParts& parts, const PlayBody& body, std::span<const Vec3> points) {
    const Pose pose = parts.world().state(body.body).pose;
    const Vec3 frame = frameOf(body);
    std::vector<Vec3> local;
    for (const Vec3& point : points)
        local.push_back(glm::conjugate(pose.orientation) * (point - pose.position) + frame);
    return local;
}

/// The impulse that the bonds of a body took, between it and its impactor: at most the one that stops them.
void applyBondImpulse(SessionParts& parts, const PlayBody& body, const BondStrike& strike, Vec3 normal, double taken) {
    const PlayBody& impactor = *findBody(parts.state(), strike.impactor);
    MovingMass hit = movingMass(parts.world(), body.body), hitting = movingMass(parts.world(), impactor.body);
    EnergyEntry entry{.change = EnergyChange::Bonds, .body = body.number};
    entry.before = hit.kineticEnergy() + hitting.kineticEnergy();
    const Vec3 point = strike.impact.point;
    const double stopping = stoppingImpulse(hitting, hit, point, normal, strike.impact.restitution);
    const Vec3 impulse = std::min(taken, stopping) * normal;
    const std::string cause = "The hit on " + quotedName(nameOf(body, parts.state().origins[body.origin]));
    if (!isApplicable(parts, body, impulse, point, cause)) return;
    for (const auto& [id, mass, given] : {std::tuple(impactor.body, &hitting, -impulse), {body.body, &hit, impulse}}) {
        if (mass->inverseMass > 0.0) applyImpulse(parts, id, given, point, cause);
    }
    entry.after =
        movingMass(parts.world(), body.body).kineticEnergy() + movingMass(parts.world(), impactor.body).kineticEnergy();
    parts.state().events.energy.push_back(entry);
}

/// Adds what another hit in the same step did to a body; the stronger one is reported.
void add(BrokenBonds one, BrokenBonds& all) {
    const double impulse = all.impulse + one.impulse;
    one.bonds.insert(one.bonds.end(), all.bonds.begin(), all.bonds.end());
    std::ranges::sort(one.bonds);
    if (one.impulse <= all.impulse) {
        std::swap(one.bonds, all.bonds);
    } else {
        all = std::move(one);
    }
    all.impulse = impulse;
}

/// The unbroken bonds of a body, ascending.
std::vector<std::uint32_t> bondsOf(const StructureState& state, const PlayBody& body) {
    std::vector<std::uint32_t> bonds;
    for (const std::uint32_t node : body.nodes) {
        for (const BondLink& link : state.structure->graph.linksOf(node)) {
            if (state.damage[link.bond] != kBroken) bonds.push_back(link.bond);
        }
    }
    std::ranges::sort(bonds);
    bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
    return bonds;
}

/// Breaks and damages bonds of a body, each by its own load, and splits the body. Clusters that hold are not loaded.
void breakByLoads(SessionParts& parts, const PlayBody& body, std::vector<BondLoad> loads, Vec3 point) {
    StructureState& state = parts.state().structures[body.structure];
    const HeldClusters held = heldClusters(parts, body);
    std::erase_if(loads, [&](const BondLoad& load) { return held.holds(load.bond); });
    HitOutcome outcome = applyLoads(state.structure->capacities, state.structure->rule, loads, state.damage);
    shareMortarDamage(parts, body.structure);
    if (outcome.broken.empty()) return;
    splitBodies(parts,
                {{.body = body.number, .point = point, .level = held.breaking, .bonds = std::move(outcome.broken)}});
}

}  // namespace

std::shared_ptr<const PlayStructure> knownStructure(const SessionParts& parts, const PlayBody& body) {
    if (body.structure != kNone) return parts.state().structures[body.structure].structure;
    return structureIn(parts.scene(), parts.state().origins[body.origin], body.fragment);
}

bool breakHitBonds(SessionParts& parts, std::span<const Impact> impacts) {
    std::map<std::uint32_t, BrokenBonds> broken;  // by body
    for (const BondStrike& strike : strikesOf(parts, impacts)) {
        PlayBody& body = *findBody(parts.state(), strike.body);
        const double impulse = strike.impact.impulse();
        const std::shared_ptr<const PlayStructure> structure = knownStructure(parts, body);
        if (!parts.state().hasDestruction || impulse < structure->leastImpulse) {
            tellWeakHit(parts, *structure, strike);
            continue;
        }
        const auto before = broken.find(body.number);  // an earlier hit, which may have broken the last of a level
        const auto level = before != broken.end() ? std::optional(before->second.level) : std::nullopt;
        BrokenBonds damaged = damageBonds(parts, body, strike.points, impulse, level);
        if (damaged.impulse <= 0.0) continue;
        damaged.normal = strike.impact.first == body.body ? -strike.impact.normal : strike.impact.normal;
        damaged.point = strike.impact.point;
        damaged.impactor = strike.impactor;
        damaged.speed = strike.impact.approachSpeed;
        damaged.restitution = strike.impact.restitution;
        applyBondImpulse(parts, body, strike, damaged.normal, damaged.impulse);
        if (!damaged.bonds.empty()) add(std::move(damaged), broken[body.number]);
    }
    std::vector<BrokenBonds> bodies;
    for (auto& [number, one] : broken) bodies.push_back(std::move(one));
    return splitBodies(parts, std::move(bodies));
}

BrokenBonds damageBonds(SessionParts& parts, PlayBody& body, std::span<const Vec3> points, double impulse,
                        std::optional<ClusterLevel> level) {
    StructureState& state = structureOf(parts, body);
    const PlayStructure& structure = *state.structure;
    const std::vector<Vec3> local = inStructure(parts, body, points);
    HeldClusters held = heldClusters(parts, body);
    held.breaking = level.value_or(held.breaking);
    HitOutcome outcome = applyHit(structure.graph, structure.capacities, structure.rule, {local, impulse, held},
                                  state.bodyOfNode, body.number, state.damage);
    if (outcome.utilization > 0.0)
        parts.state().events.impacts.push_back({body.number, impulse, impulse / outcome.utilization, points.front()});
    shareMortarDamage(parts, body.structure);
    return {.body = body.number,
            .impulse = outcome.taken,
            .point = points.front(),
            .level = held.breaking,
            .bonds = std::move(outcome.broken)};
}

void breakAllBonds(SessionParts& parts, PlayBody& body) {
    const StructureState& state = structureOf(parts, body);
    std::vector<BondLoad> loads;
    for (const std::uint32_t bond : bondsOf(state, body)) {
        loads.push_back({bond, 2.0 * state.structure->capacities[bond]});
    }
    breakByLoads(parts, body, std::move(loads), parts.world().state(body.body).centre);
}

void blastBonds(SessionParts& parts, Vec3 origin, const Blast& blast) {
    std::vector<std::uint32_t> bonded;
    for (const PlayBody& body : parts.state().bodies) {
        const Box3 box = parts.world().box(body.body);
        const double distance = glm::distance(origin, glm::clamp(origin, box.min, box.max));
        if (body.bondedFracture() != nullptr && distance < blast.radius) bonded.push_back(body.number);
    }
    for (const std::uint32_t number : bonded) {
        PlayBody& body = *findBody(parts.state(), number);
        if (body.bondedFracture() == nullptr) continue;  // mortar that broke before left a single fragment of it
        const StructureState& state = structureOf(parts, body);
        const Vec3 local = inStructure(parts, body, {&origin, 1}).front();
        std::vector<BondLoad> loads;
        for (const std::uint32_t index : bondsOf(state, body)) {
            const Bond& bond = state.structure->graph.bonds[index];
            const double fraction = 1.0 - glm::distance(local, bond.centroid) / blast.radius;
            if (fraction > 0.0) loads.push_back({index, blast.impulse * fraction * bond.area});
        }
        breakByLoads(parts, body, std::move(loads), origin);
    }
}

}  // namespace rubble
