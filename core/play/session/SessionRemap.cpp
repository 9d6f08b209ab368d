#include "core/play/session/SessionRemap.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/play/breaking/ApplyDamage.h"
#include "core/play/breaking/ImpactCutting.h"
#include "core/play/damage/BondLayout.h"

namespace rubble {
namespace {

/// Why no damage can be mapped to an instance; nothing if it can.
std::optional<std::string> lossOf(const PlayScene& to, const Instance& before, const InstanceDamage& damage) {
    const std::string name = "Instance " + quotedName(before.name);
    const Instance* instance = findInstance(to.project, before.id);
    if (instance == nullptr) return name + " is gone; its damage is dropped.";
    if (instance->asset != before.asset) return name + " has another asset; its damage is dropped.";
    if (instance->isUnbreakable) return name + " is unbreakable now; its damage is dropped.";
    const bool isBonded = to.assets.at(variantOf(*instance))->isBonded;
    if (isBonded != (damage.kind == DamageKind::Bonds)) {
        return name + (isBonded ? " breaks along bonds now" : " breaks whole now") + "; its damage is dropped.";
    }
    if (damage.cut && !findAsset(to.project, instance->asset)->cutAtImpact) {
        return name + " is not cut at the point of impact any more; its damage is dropped.";
    }
    return std::nullopt;
}

/// What a damage of an instance is to be of.
Result<std::shared_ptr<const PlayAsset>> targetOf(const PlayScene& to, const Instance& instance,
                                                  const InstanceDamage& damage) {
    if (!damage.cut) return to.assets.at(variantOf(instance));
    return cutAtImpact(*findAsset(to.project, instance.asset), damage.cut->place(), damage.cut->number,
                       to.assets.at(variantOf(instance)).get());
}

PlayOrigin originOf(const Instance& instance) { return {instance.name, instance.id, instance.asset, instance.variant}; }

/// The damage of an instance, in another version of its scene.
Result<RemappedDamage> remapped(const PlayScene& from, const Instance& before, const InstanceDamage& damage,
                                const PlayScene& to, const Instance& instance) {
    const ContentHash bake =
        damageHash(*findAsset(to.project, instance.asset), *to.assets.at(variantOf(instance))->bake);
    if (damage.kind == DamageKind::Bonds) {
        return remappedBonds(damage, bondLayout(from, originOf(before)), bondLayout(to, originOf(instance)), bake);
    }
    const auto source = damagedAsset(from, variantOf(before), damage);
    const auto target = targetOf(to, instance, damage);
    if (!source || !target) return source ? target.error() : source.error();
    return remappedDamage(damage, **source, **target, bake);
}

}  // namespace

Result<RemappedSession> remappedSession(const Session& session, const PlayScene& to) {
    RemappedSession made;
    for (const auto& [id, damage] : session.damage()) {
        if (damage.isIntact()) continue;
        const Instance& before = *findInstance(session.scene().project, id);
        if (const std::optional<std::string> loss = lossOf(to, before, damage)) {
            made.losses.push_back(*loss);
            continue;
        }
        const Instance& instance = *findInstance(to.project, id);
        Result<RemappedDamage> mapped = remapped(session.scene(), before, damage, to, instance);
        if (!mapped) return mapped.error();
        if (!mapped->dropped.empty()) {
            const bool isBonds = damage.kind == DamageKind::Bonds;
            made.losses.push_back(
                "Instance " + quotedName(instance.name) + ": " +
                countText(mapped->dropped.size(), isBonds ? "damaged bond does" : "broken fragment does",
                          isBonds ? "damaged bonds do" : "broken fragments do") +
                " not exist or break in this bake and " + (mapped->dropped.size() == 1 ? "is" : "are") + " dropped.");
        }
        made.damage[id] = std::move(mapped->damage);
    }
    return made;
}

}  // namespace rubble
