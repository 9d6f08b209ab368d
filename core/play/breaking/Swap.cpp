#include "core/play/breaking/Swap.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/base/Stopwatch.h"
#include "core/play/breaking/DamageDone.h"
#include "core/play/breaking/ImpactCutting.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>

namespace rubble {
namespace {

/// The damage of a step to breakable bodies, by number.
std::vector<std::pair<PlayBody, DamageDone>> damageToBreakableBodies(const SessionParts& parts,
                                                                     std::span<const Impact> impacts) {
    std::vector<std::pair<PlayBody, DamageDone>> damaged;
    for (const DamageDone& damage : damageOf(impacts, parts.world(), parts.scene().project.damage.rule)) {
        const PlayBody* body = findBody(parts.state(), static_cast<std::uint32_t>(parts.world().tag(damage.body)));
        RUBBLE_ASSERT(body != nullptr);
        if (body->fracture() != nullptr) damaged.emplace_back(*body, damage);
    }
    std::ranges::sort(damaged, {}, [](const auto& one) { return one.first.number; });
    return damaged;
}

PendingBreak breakBy(const SessionParts& parts, const PlayBody& body, const Impact& impact, double damage) {
    PendingBreak broken = pendingBreak(parts, body);
    const bool isFirst = impact.first == body.body;
    broken.event.impact = damage;
    broken.event.point = impact.point;
    broken.event.normal = isFirst ? -impact.normal : impact.normal;
    broken.event.impactor = isFirst ? impact.second : impact.first;
    broken.event.impactorNumber = static_cast<std::uint32_t>(parts.world().tag(broken.event.impactor));
    broken.event.approachSpeed = impact.approachSpeed;
    broken.restitution = impact.restitution;
    return broken;
}

/// The asset whose fragments replace the body: its own, or one fractured at the point of impact, which sets
/// PendingBreak::cut.
std::shared_ptr<const PlayAsset> assetToSwap(SessionParts& parts, PendingBreak& broken) {
    if (broken.cutAsset) return broken.cutAsset;
    const PlayBody& body = broken.event.body;
    const Asset& asset = *findAsset(parts.scene().project, body.asset->bake->asset);
    if (!asset.cutAtImpact || body.fragment != kNone) return body.asset;
    const Vec3 local = glm::conjugate(broken.pose.orientation) * (broken.event.point - broken.pose.position);
    const ImpactCut at{.point = Vec2(local), .number = body.number, .height = asset.isPrism() ? 0.0 : local.z};
    Result<std::shared_ptr<const PlayAsset>> cut = cutAtImpact(asset, at.place(), at.number, body.asset.get());
    if (cut && (*cut)->fractureOf(kNone) != nullptr) {
        broken.cut = at;
        return std::move(*cut);
    }
    parts.state().events.diagnostics.push_back(diagnostic(
        DiagnosticCode::PatternFallback, placeOf(body),
        "A body broke into the fragments of its pattern, since it cannot be fractured at the point of impact: " +
            (cut ? std::string("this would give one fragment.") : cut.error().message)));
    return body.asset;
}

/// Where the centre of mass of a fragment is in the whole, in world space.
Vec3 centreInWhole(const PendingBreak& broken, const PlayAsset& asset, std::uint32_t fragment) {
    const PlaySolid& solid = asset.fragments[fragment];
    const Vec3 offset = solid.offset - asset.solid(broken.event.body.fragment).offset;
    return broken.pose.position + broken.pose.orientation * (offset + solid.shape->mass.centre);
}

/// A fragment at its position in the whole, moving as that point of the whole did; with the thesis preset, with the
/// velocity of the whole's centre.
BodyDefinition fragmentDefinition(const SessionParts& parts, const PendingBreak& broken, const PlayAsset& asset,
                                  std::uint32_t fragment) {
    const PlaySolid& solid = asset.fragments[fragment];
    const Vec3 offset = solid.offset - asset.solid(broken.event.body.fragment).offset;
    const BodyMaterial material = bodyMaterial(parts, asset, fragment, PlayRole::Debris);
    BodyDefinition definition{
        .shape = solid.shape,
        .pose = {broken.pose.position + broken.pose.orientation * offset, broken.pose.orientation},
        .velocity = broken.mass.velocity,
        .angularVelocity = spinOfPart(*solid.shape, broken.pose.orientation, broken.mass.angularVelocity),
        .density = material.density,
        .friction = material.friction,
        .restitution = material.restitution};
    if (!parts.scene().project.damage.isThesis) {
        const Vec3 centre = definition.pose.position + broken.pose.orientation * solid.shape->mass.centre;
        definition.velocity = broken.mass.velocityAt(centre);
    }
    definition.velocity = limitedVelocity(definition.velocity);
    definition.angularVelocity = limitedVelocity(definition.angularVelocity);
    return definition;
}

/// Adds a break to the damage of the body's origin.
void addDamage(SessionParts& parts, const PendingBreak& broken) {
    const PlayBody& body = broken.event.body;
    const PlayAsset& asset = *broken.event.asset;
    InstanceDamage& damage = parts.state().damage[body.origin];
    if (damage.broken.empty()) {
        damage = intactDamage(*findAsset(parts.scene().project, body.asset->bake->asset), *body.asset);
    }
    if (broken.cut) {
        damage.cut = broken.cut;
        damage.broken.assign(asset.fractures.size(), false);
    }
    damage.broken[asset.solid(body.fragment).fracture] = true;
}

/// Removes the whole from the world.
void removeWhole(SessionParts& parts, PendingBreak& broken, Stopwatch& watch) {
    broken.event.asset = assetToSwap(parts, broken);
    addDamage(parts, broken);
    const BodyState state = parts.world().state(broken.event.body.body);
    broken.event.pose = broken.pose;
    broken.event.velocity = state.velocity;
    broken.event.angularVelocity = state.angularVelocity;
    removeFromWorld(parts, broken.event.body.number);
    broken.event.milliseconds = watch.lap();
}

/// Adds a fragment. One that cannot be simulated is reported, and its number stays free.
BodyId addFragment(SessionParts& parts, const PendingBreak& broken, std::uint32_t fragment) {
    const PlayBreak& event = broken.event;
    PlayBody body{.role = PlayRole::Debris, .origin = event.body.origin, .asset = event.asset, .fragment = fragment};
    const Result<std::uint32_t> added = addBody(parts, fragmentDefinition(parts, broken, *event.asset, fragment), body);
    if (!added) {
        ++parts.state().nextNumber;
        parts.state().events.diagnostics.push_back(
            diagnostic(DiagnosticCode::LeftWorld, placeOf(body),
                       quotedName(nameOf(body, parts.state().origins[body.origin])) + " was left out at step " +
                           std::to_string(event.step) + ": " + added.error().message));
        return {};
    }
    parts.state().events.born.push_back(parts.state().bodies.back());
    return parts.state().bodies.back().body;
}

/// Adds the energies of a whole and of the fragments that replaced it. They are where they were in the whole: it has
/// no potential energy to lose, but the world rounds positions.
void auditSwap(SessionParts& parts, const PendingBreak& broken, std::span<const BodyId> fragments) {
    const PlayBreak& event = broken.event;
    const Vec3 gravity = parts.world().gravity();
    EnergyEntry entry{.change = event.asset == event.body.asset ? EnergyChange::Swap : EnergyChange::Cut,
                      .body = event.body.number,
                      .before = broken.mass.kineticEnergy()};
    for (std::uint32_t k = 0; k < event.fragmentCount; ++k) {
        if (fragments[k].index == 0) continue;
        const Vec3 exact = centreInWhole(broken, *event.asset, event.asset->fractureOf(event.body.fragment)->first + k);
        const Vec3 weight = parts.world().mass(fragments[k]) * gravity;
        const double size = glm::length(weight), distance = glm::length(exact);
        entry.after += kineticEnergy(parts.world(), fragments[k]);
        entry.after -= glm::dot(weight, parts.world().state(fragments[k]).centre - exact);
        entry.rounding += size * kPositionRounding * std::max(1.0, distance / kRoundedDistance);
    }
    // The preset gives each fragment 100 kg, whatever the whole weighs.
    if (parts.scene().project.damage.isThesis) entry.given = entry.after - entry.before;
    parts.state().events.energy.push_back(entry);
}

/// Adds the fragments to the world.
void addFragments(SessionParts& parts, PendingBreak& broken, Stopwatch& watch) {
    PlayBreak& event = broken.event;
    const PlayFracture& fracture = *event.asset->fractureOf(event.body.fragment);
    event.firstFragment = parts.state().nextNumber;
    event.fragmentCount = fracture.count;
    std::vector<BodyId> fragments(fracture.count);  // index 0 for those left out
    for (std::uint32_t k = 0; k < fracture.count; ++k) fragments[k] = addFragment(parts, broken, fracture.first + k);
    for (const PlayContact& pair : fracture.neighbours) {
        const BodyId first = fragments[pair.first - fracture.first], second = fragments[pair.second - fracture.first];
        if (first.index != 0 && second.index != 0) parts.world().addContact(first, second, pair.manifolds);
    }
    event.milliseconds += watch.lap();
    auditSwap(parts, broken, fragments);
    parts.state().events.breaks.push_back(event);
}

}  // namespace

PendingBreak pendingBreak(const SessionParts& parts, const PlayBody& body) {
    PendingBreak broken;
    broken.event = {
        .step = parts.state().step + 1, .body = body, .threshold = thresholdOf(parts.state(), parts.scene(), body)};
    broken.pose = parts.world().state(body.body).pose;
    const BodyMaterial material = bodyMaterial(parts, *body.asset, body.fragment, body.role);
    broken.mass = parts.world().kind(body.body) == BodyKind::Dynamic
                      ? movingMass(parts.world(), body.body)
                      : restingMass(parts.world().shape(body.body), material.density, broken.pose);
    return broken;
}

void applyBreaks(SessionParts& parts, std::vector<PendingBreak> breaks) {
    if (!parts.scene().project.damage.isThesis) {
        applyBreakImpulses(parts, breaks);
    }
    Stopwatch watch;
    for (PendingBreak& broken : breaks) removeWhole(parts, broken, watch);
    eraseRemovedBodies(parts.state());
    watch.lap();
    for (PendingBreak& broken : breaks) addFragments(parts, broken, watch);
}

bool breakHitBodies(SessionParts& parts, std::span<const Impact> impacts) {
    std::vector<PendingBreak> breaks;
    for (const auto& [body, damage] : damageToBreakableBodies(parts, impacts)) {
        const double threshold = thresholdOf(parts.state(), parts.scene(), body);
        const Impact& impact = impacts[damage.impact];
        parts.state().events.impacts.push_back({body.number, damage.amount, threshold, impact.point});
        if (parts.state().hasDestruction && damage.amount >= threshold) {
            breaks.push_back(breakBy(parts, body, impact, damage.amount));
        }
    }
    if (breaks.empty()) return false;
    applyBreaks(parts, std::move(breaks));
    return true;
}

}  // namespace rubble
