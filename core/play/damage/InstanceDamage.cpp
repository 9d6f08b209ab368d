#include "core/play/damage/InstanceDamage.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

Error otherBake(ContentHash one, ContentHash other) {
    return {ErrorCode::BadInput, "The damage is of the bake " + one.hex() + ", but the instance is of the bake " +
                                     other.hex() + "; only damage of the same bake can be applied."};
}

/// Checks that two damages are of the same instance.
Status checkSame(const InstanceDamage& one, const InstanceDamage& other) {
    if (one.bake != other.bake) return otherBake(one.bake, other.bake);
    if (one.kind != other.kind) {
        return Error{ErrorCode::BadInput,
                     "One damage is of fractures, the other of bonds; only damage of the same kind can be merged."};
    }
    if (one.cut == other.cut && one.broken.size() != other.broken.size()) {
        const char* what = one.kind == DamageKind::Bonds ? "bonds" : "fractures";
        return Error{ErrorCode::BadInput, "The damages are of " + std::to_string(one.broken.size()) + " and " +
                                              std::to_string(other.broken.size()) + " " + what +
                                              "; only damage of the same " + what + " can be merged."};
    }
    return success();
}

}  // namespace

std::array<std::uint64_t, 4> ImpactCut::key() const {
    return {number, std::bit_cast<std::uint64_t>(point.x), std::bit_cast<std::uint64_t>(point.y),
            std::bit_cast<std::uint64_t>(height)};
}

bool InstanceDamage::isIntact() const {
    return partial.empty() && std::ranges::none_of(broken, [](bool bit) { return bit; });
}

ContentHash damageHash(const Asset& asset, const Bake& bake) {
    if (!asset.cutAtImpact) return bake.input;
    Hasher hasher;
    hasher.add(bake.input.high);
    hasher.add(bake.input.low);
    hasher.add(std::uint64_t{asset.cutAtImpact->fragments});
    hasher.add(asset.cutAtImpact->falloffRadius);
    return hasher.digest();
}

InstanceDamage intactDamage(const Asset& asset, const PlayAsset& ready) {
    return {.bake = damageHash(asset, *ready.bake), .broken = std::vector<bool>(ready.fractures.size())};
}

Result<InstanceDamage> mergedDamage(const InstanceDamage& one, const InstanceDamage& other) {
    if (const Status same = checkSame(one, other); !same) return same.error();
    if (one.cut != other.cut) return one.cut < other.cut ? other : one;
    InstanceDamage merged = one;
    for (std::size_t k = 0; k < merged.broken.size(); ++k) merged.broken[k] = one.broken[k] || other.broken[k];
    for (const auto& [bond, damage] : other.partial) merged.partial[bond] = std::max(merged.partial[bond], damage);
    std::erase_if(merged.partial, [&](const auto& bond) { return merged.broken[bond.first]; });
    return merged;
}

Result<InstanceDamage> damageSince(const InstanceDamage& now, const InstanceDamage& before) {
    if (const Status same = checkSame(now, before); !same) return same.error();
    InstanceDamage since = now;
    if (now.cut != before.cut) return since;
    for (std::size_t k = 0; k < since.broken.size(); ++k) since.broken[k] = now.broken[k] && !before.broken[k];
    std::erase_if(since.partial, [&](const auto& bond) {
        const auto then = before.partial.find(bond.first);
        return then != before.partial.end() && then->second >= bond.second;
    });
    return since;
}

std::vector<std::uint32_t> brokenFragments(const PlayAsset& ready) {
    std::vector<std::uint32_t> fragments(ready.fractures.size(), kNone);
    for (std::uint32_t fragment = 0; fragment < ready.fragments.size(); ++fragment) {
        const std::uint32_t fracture = ready.fragments[fragment].fracture;
        if (fracture != kNone) fragments[fracture] = fragment;
    }
    return fragments;
}

std::optional<std::string> damageFault(const InstanceDamage& damage, ContentHash bake, const PlayAsset& ready) {
    if (damage.bake != bake) return otherBake(damage.bake, bake).message;
    if (damage.kind != DamageKind::Fractures) return "The damage is of bonds, but the asset breaks whole.";
    if (damage.broken.size() != ready.fractures.size()) {
        return "The damage is of " + std::to_string(damage.broken.size()) + " fractures, but the asset has " +
               std::to_string(ready.fractures.size()) + ".";
    }
    if (damage.cut && (ready.whole.fracture == kNone || !damage.broken[ready.whole.fracture])) {
        return "The damage has a cut, but what was cut is not broken.";
    }
    const std::vector<std::uint32_t> fragments = brokenFragments(ready);
    for (std::size_t k = 0; k < damage.broken.size(); ++k) {
        if (!damage.broken[k] || fragments[k] == kNone) continue;
        const std::uint32_t from = fractureContaining(ready, fragments[k]);
        if (from != kNone && damage.broken[from]) continue;
        return "Fragment " + ready.bake->fragmentPath(fragments[k]) +
               " is broken, but what it is a fragment of is not.";
    }
    return std::nullopt;
}

std::uint32_t fractureContaining(const PlayAsset& ready, std::uint32_t fragment) {
    const auto next = std::ranges::upper_bound(ready.fractures, fragment, {}, &PlayFracture::first);
    if (next == ready.fractures.begin()) return kNone;
    const PlayFracture& before = *std::prev(next);
    return fragment - before.first < before.count ? static_cast<std::uint32_t>(next - ready.fractures.begin()) - 1
                                                  : kNone;
}

}  // namespace rubble
