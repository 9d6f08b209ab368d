#include "core/play/damage/DamageRemap.h"

namespace rubble {
namespace {

/// The path of a fragment; empty for the whole.
FragmentPath pathOf(const PlayAsset& asset, std::uint32_t fragment) {
    return fragment == kNone ? FragmentPath() : asset.bake->fragmentPath(fragment);
}

/// Whether a fracture can break: what it is of came free by a broken one.
bool isFree(const PlayAsset& asset, std::uint32_t fragment, const InstanceDamage& damage) {
    if (fragment == kNone) return true;
    const std::uint32_t from = fractureContaining(asset, fragment);
    return from != kNone && damage.broken[from];
}

}  // namespace

Result<RemappedDamage> remappedDamage(const InstanceDamage& damage, const PlayAsset& from, const PlayAsset& to,
                                      ContentHash bake) {
    if (const std::optional<std::string> fault = damageFault(damage, damage.bake, from)) {
        return Error{ErrorCode::BadInput, *fault};
    }
    std::map<FragmentPath, std::uint32_t> fractures;
    const std::vector<std::uint32_t> targets = brokenFragments(to), sources = brokenFragments(from);
    for (std::uint32_t k = 0; k < targets.size(); ++k) fractures[pathOf(to, targets[k])] = k;
    RemappedDamage remapped;
    remapped.damage = {.bake = bake, .cut = damage.cut, .broken = std::vector<bool>(to.fractures.size())};
    for (std::size_t k = 0; k < sources.size(); ++k) {
        if (!damage.broken[k]) continue;
        const FragmentPath path = pathOf(from, sources[k]);
        const auto found = fractures.find(path);
        if (found != fractures.end() && isFree(to, targets[found->second], remapped.damage)) {
            remapped.damage.broken[found->second] = true;
        } else {
            remapped.dropped.push_back(path);
        }
    }
    return remapped;
}

}  // namespace rubble
