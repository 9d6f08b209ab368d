#include "core/asset/compare/AssetDifference.h"

#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

std::string volumeText(double volume) { return quantityText(QuantityKind::Volume, volume); }

/// The bake of an asset; an empty one for null.
Result<Bake> bakeOf(const Asset* asset, const TaskContext& task) { return asset ? bake(*asset, task) : Bake(); }

}  // namespace

std::vector<AssetPair> assetPairs(const Project& before, const Project& after) {
    std::vector<AssetPair> pairs;
    for (const Asset& asset : after.assets) pairs.push_back({findAsset(before, asset.name), &asset});
    const auto isMatched = [&](const Asset& asset) {
        return std::ranges::find(pairs, &asset, &AssetPair::before) != pairs.end();
    };
    for (AssetPair& pair : pairs) {
        const Asset* same = findAsset(before, pair.after->id);
        if (!pair.before && same && !isMatched(*same)) pair.before = same;
    }
    for (const Asset& asset : before.assets) {
        if (!isMatched(asset)) pairs.push_back({&asset, nullptr});
    }
    return pairs;
}

Result<AssetDifference> differenceOf(const Project& before, const Project& after, const AssetPair& pair,
                                     const TaskContext& task) {
    const std::array states{pair.before, pair.after};
    std::array<std::optional<Result<Bake>>, 2> bakes;
    TaskContext each = task;
    each.threads = std::max(1, task.threads / 2);
    each.progress = nullptr;  // two threads would report it
    forEachIndex(states.size(), task.threads, [&](std::size_t k) { bakes[k] = bakeOf(states[k], each); });
    for (const std::optional<Result<Bake>>& baked : bakes) {
        if (!*baked) return baked->error();
    }
    AssetDifference difference{.pair = pair, .fragments = differenceOf(**bakes[0], **bakes[1])};
    if (pair.before && pair.after) difference.recipe = recipeChanges(before, *pair.before, after, *pair.after);
    return difference;
}

std::string sentenceOf(const LevelDifference& level) {
    std::string text = std::to_string(level.after) + (level.after == 1 ? " fragment" : " fragments");
    if (level.before != level.after) text += (level.before == 1 ? ", was " : ", were ") + std::to_string(level.before);
    const std::array<const char*, kFragmentChanges> words{" removed", " added", " moved", " reshaped"};
    std::string changes;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (level.changed[k] == 0) continue;
        changes += (changes.empty() ? ": " : ", ") + std::to_string(level.changed[k]) + words[k];
    }
    return text + (changes.empty() ? ", unchanged" : changes);
}

std::string sentenceOf(const FragmentDifference& fragment) {
    switch (fragment.change) {
        case FragmentChange::Gone: return fragment.path + " removed, was " + volumeText(fragment.volumeBefore);
        case FragmentChange::Added: return fragment.path + " added, " + volumeText(fragment.volumeAfter);
        case FragmentChange::Moved:
        case FragmentChange::Reshaped: break;
    }
    const bool isMoved = fragment.change == FragmentChange::Moved;
    std::string text =
        fragment.path + (isMoved ? " moved by " + quantityText(QuantityKind::Length, fragment.shift) : "");
    const std::string before = volumeText(fragment.volumeBefore), after = volumeText(fragment.volumeAfter);
    if (!isMoved) text += " changed shape";
    return before == after ? text + ", " + after : text + ", now " + after + ", was " + before;
}

}  // namespace rubble
