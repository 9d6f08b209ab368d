#include "core/play/session/SessionRemap.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/play/breaking/ApplyDamage.h"
#include "core/play/breaking/CutAtImpact.h"
#include "core/play/damage/DamageRemap.h"

namespace rubble {
namespace {

/// Why no damage can be mapped to an instance; nothing if it can.
std::optional<std::string> lossOf(const PlayScene& to, const Instance& before, const InstanceDamage& damage) {
    const std::string name = "Instance " + quotedName(before.name);
    const Instance* instance = findInstance(to.project, before.id);
    if (instance == nullptr) return name + " is gone; its damage is dropped.";
    if (instance->asset != before.asset) return name + " has another asset; its damage is dropped.";
    if (instance->isUnbreakable) return name + " is unbreakable now; its damage is dropped.";
    if (damage.cut && !findAsset(to.project, instance->asset)->cutAtImpact) {
        return name + " is not cut at the point of impact any more; its damage is dropped.";
    }
    return std::nullopt;
}

/// What a damage of an instance is to be of.
Result<std::shared_ptr<const PlayAsset>> targetOf(const PlayScene& to, const Instance& instance,
                                                  const InstanceDamage& damage) {
    if (!damage.cut) return to.assets.at(variantOf(instance));
    return cutAtImpact(*findAsset(to.project, instance.asset), damage.cut->point, damage.cut->number);
}

}  // namespace

Result<RemappedSession> remappedSession(const Session& session, const PlayScene& to) {
    RemappedSession remapped;
    for (const auto& [id, damage] : session.damage()) {
        if (damage.isIntact()) continue;
        const Instance& before = *findInstance(session.scene().project, id);
        if (const std::optional<std::string> loss = lossOf(to, before, damage)) {
            remapped.losses.push_back(*loss);
            continue;
        }
        const Instance& instance = *findInstance(to.project, id);
        const auto source = damagedAsset(session.scene(), variantOf(before), damage);
        const auto target = targetOf(to, instance, damage);
        if (!source || !target) return source ? target.error() : source.error();
        const ContentHash bake =
            damageHash(*findAsset(to.project, instance.asset), *to.assets.at(variantOf(instance))->bake);
        Result<RemappedDamage> mapped = remappedDamage(damage, **source, **target, bake);
        if (!mapped) return mapped.error();
        if (!mapped->dropped.empty()) {
            remapped.losses.push_back("Instance " + quotedName(instance.name) + ": " +
                                      countText(mapped->dropped.size(), "broken fragment does", "broken fragments do") +
                                      " not exist or break in this bake and " +
                                      (mapped->dropped.size() == 1 ? "is" : "are") + " dropped.");
        }
        remapped.damage[id] = std::move(mapped->damage);
    }
    return remapped;
}

}  // namespace rubble
