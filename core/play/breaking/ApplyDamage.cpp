#include "core/play/breaking/ApplyDamage.h"

#include "core/base/MessageText.h"
#include "core/play/breaking/Collapsing.h"
#include "core/play/breaking/ImpactCutting.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/breaking/Swap.h"
#include "core/play/damage/BondLayout.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

/// A damage to apply to the instance of an origin.
struct Target {
    InstanceDamage damage;                   // merged with what is broken already
    std::shared_ptr<const PlayAsset> asset;  // what it is of; null: of bonds
};
using Targets = std::map<std::uint32_t, Target>;  // by origin

Error ofInstance(const PlayOrigin& origin, const std::string& message) {
    return {ErrorCode::BadInput, "Instance " + quotedName(origin.name) + ": " + message};
}

/// Damages the bonds of the structure that bodies are of, whose first bond is at `first` in the damage, and splits
/// them.
void damageStructure(SessionParts& parts, std::span<const std::uint32_t> bodies, std::uint32_t first,
                     const InstanceDamage& damage) {
    StructureState& state = structureOf(parts, *findBody(parts.state(), bodies.front()));
    bool isChanged = false;
    for (std::uint32_t bond = 0; bond < state.damage.size(); ++bond) {
        const auto partial = damage.partial.find(first + bond);
        BondDamage one = partial != damage.partial.end() ? partial->second : kIntact;
        if (damage.broken[first + bond]) one = kBroken;
        isChanged |= one == kBroken && state.damage[bond] != kBroken;
        state.damage[bond] = std::max(state.damage[bond], one);
    }
    if (!isChanged) return;
    std::vector<BrokenBonds> broken;
    for (const std::uint32_t body : bodies) broken.push_back({.body = body});
    splitBodies(parts, std::move(broken));
}

/// The damage of the bonds of an origin.
InstanceDamage damageOfBonds(const PlayScene& scene, const SessionState& state, std::uint32_t index, ContentHash bake) {
    const BondLayout layout = bondLayout(scene, state.origins[index]);
    InstanceDamage damage = intactBonds(bake, layout);
    for (const StructureState& structure : state.structures) {
        if (structure.origin != index) continue;
        const std::uint32_t first = layout.firstBond[layout.structureOf(structure.parent)];
        for (std::uint32_t bond = 0; bond < structure.damage.size(); ++bond) {
            if (structure.structure->initialDamage[bond] == kBroken) continue;  // it never held
            const BondDamage one = structure.damage[bond];
            if (one == kBroken) damage.broken[first + bond] = true;
            if (one != kBroken && one != kIntact) damage.partial[first + bond] = one;
        }
    }
    return damage;
}

/// Whether a damage has any in a range of bonds.
bool hasDamage(const InstanceDamage& damage, std::uint32_t begin, std::uint32_t end) {
    const auto partial = damage.partial.lower_bound(begin);
    return (partial != damage.partial.end() && partial->first < end) ||
           std::find(damage.broken.begin() + begin, damage.broken.begin() + end, true) != damage.broken.begin() + end;
}

/// Damages the bonds of an origin and splits its bodies, level by level.
void applyToBonds(SessionParts& parts, std::uint32_t index, const InstanceDamage& damage) {
    const BondLayout layout = bondLayout(parts.scene(), parts.state().origins[index]);
    for (std::size_t k = 0; k < layout.structures.size(); ++k) {
        std::vector<std::uint32_t> bodies;
        for (const PlayBody& body : parts.state().bodies) {
            const bool isOne = body.origin == index && body.fragment == layout.structures[k]->parent;
            if (isOne && body.bondedFracture() != nullptr) bodies.push_back(body.number);
        }
        if (!bodies.empty() && hasDamage(damage, layout.firstBond[k], layout.firstBond[k + 1]))
            damageStructure(parts, bodies, layout.firstBond[k], damage);
    }
}

/// What is broken of an origin.
InstanceDamage damageOfOrigin(const PlayScene& scene, const SessionState& state, std::uint32_t index) {
    const auto broken = state.damage.find(index);
    if (broken != state.damage.end()) return broken->second;
    const PlayOrigin& origin = state.origins[index];
    const Asset& asset = *findAsset(scene.project, origin.asset);
    const PlayAsset& ready = *scene.assets.at({origin.asset, origin.variant});
    if (ready.isBonded) return damageOfBonds(scene, state, index, damageHash(asset, *ready.bake));
    return intactDamage(asset, ready);
}

Result<Target> targetOf(const SessionParts& parts, std::uint32_t index, const InstanceDamage& damage) {
    const PlayOrigin& origin = parts.state().origins[index];
    const InstanceDamage before = damageOfOrigin(parts.scene(), parts.state(), index);
    Result<InstanceDamage> merged = mergedDamage(before, damage);
    if (!merged) return ofInstance(origin, merged.error().message);
    if (!before.isIntact() && before.cut != merged->cut) {
        return ofInstance(origin, "it was cut at another point already; merge the damages and start anew.");
    }
    if (!merged->isIntact() && findInstance(parts.scene().project, origin.instance)->isUnbreakable) {
        return ofInstance(origin, "it is unbreakable, so no damage can be applied to it.");
    }
    if (merged->kind == DamageKind::Bonds) return Target{std::move(*merged), nullptr};
    Result<std::shared_ptr<const PlayAsset>> asset =
        damagedAsset(parts.scene(), {origin.asset, origin.variant}, *merged);
    if (!asset) return ofInstance(origin, asset.error().message);
    return Target{std::move(*merged), std::move(*asset)};
}

Result<Targets> targetsOf(const SessionParts& parts, const SessionDamage& damage) {
    Targets targets;
    for (const auto& [instance, one] : damage) {
        const auto origin = std::ranges::find(parts.state().origins, instance, &PlayOrigin::instance);
        if (instance == 0 || origin == parts.state().origins.end()) {
            return Error{ErrorCode::BadInput,
                         "There is no instance " + std::to_string(instance) + ", which the damage is of."};
        }
        const auto index = static_cast<std::uint32_t>(origin - parts.state().origins.begin());
        Result<Target> target = targetOf(parts, index, one);
        if (!target) return target.error();
        if (!target->damage.isIntact()) targets.emplace(index, std::move(*target));
    }
    return targets;
}

/// The bodies to break; those that are whole into the fragments that the damage is of.
std::vector<PendingBreak> nextBreaks(const SessionParts& parts, const Targets& targets) {
    std::vector<PendingBreak> breaks;
    for (const PlayBody& body : parts.state().bodies) {
        const auto target = targets.find(body.origin);
        if (target == targets.end() || body.fracture() == nullptr) continue;
        const auto& [damage, asset] = target->second;
        if (!damage.broken[asset->solid(body.fragment).fracture]) continue;
        breaks.push_back(pendingBreak(parts, body));
        breaks.back().event.point = breaks.back().mass.centre;
        if (body.fragment != kNone) continue;
        breaks.back().cut = damage.cut;  // none: it broke into the fragments of its pattern
        breaks.back().cutAsset = asset;
    }
    return breaks;
}

}  // namespace

SessionDamage damageOfInstances(const PlayScene& scene, const SessionState& state) {
    SessionDamage damage;
    for (std::uint32_t k = 0; k < state.origins.size(); ++k) {
        if (state.origins[k].instance != 0) damage[state.origins[k].instance] = damageOfOrigin(scene, state, k);
    }
    return damage;
}

Result<std::shared_ptr<const PlayAsset>> damagedAsset(const PlayScene& scene, AssetVariant variant,
                                                      const InstanceDamage& damage) {
    const Asset& asset = *findAsset(scene.project, variant.asset);
    std::shared_ptr<const PlayAsset> ready = scene.assets.at(variant);
    const ContentHash bake = damageHash(asset, *ready->bake);
    if (damage.cut && damage.bake == bake) {
        if (!asset.cutAtImpact) return Error{ErrorCode::BadInput, "The asset is not cut at the point of impact."};
        Result<std::shared_ptr<const PlayAsset>> cut =
            cutAtImpact(asset, damage.cut->place(), damage.cut->number, ready.get());
        if (!cut) return cut.error();
        ready = std::move(*cut);
    }
    if (const std::optional<std::string> fault = damageFault(damage, bake, *ready)) {
        return Error{ErrorCode::BadInput, *fault};
    }
    return ready;
}

Status applyDamage(SessionParts& parts, const SessionDamage& damage) {
    const Result<Targets> targets = targetsOf(parts, damage);
    if (!targets) return targets.error();
    SessionState& state = parts.state();
    PlayEvents before = std::move(state.events);
    state.events = {};
    for (;;) {
        std::vector<PendingBreak> breaks = nextBreaks(parts, *targets);
        if (breaks.empty()) break;
        applyBreaks(parts, std::move(breaks));
    }
    for (const auto& [origin, target] : *targets) {
        if (target.asset == nullptr) applyToBonds(parts, origin, target.damage);
    }
    std::set<Id> changed;
    for (const auto& [origin, target] : *targets) changed.insert(state.origins[origin].instance);
    planMortarCollapse(parts, changed);
    for (PlayBody& body : state.bodies) body.heldUntil = 0.0;  // as if it had broken long ago
    for (Diagnostic& one : state.events.diagnostics) before.diagnostics.push_back(std::move(one));
    state.events = std::move(before);
    for (const auto& [origin, target] : *targets) {
        if (target.asset != nullptr) state.damage[origin] = target.damage;
    }
    return success();
}

}  // namespace rubble
