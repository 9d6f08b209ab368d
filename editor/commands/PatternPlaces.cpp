#include "editor/commands/PatternPlaces.h"

#include "core/asset/Bake.h"

#include <QCoreApplication>

#include <algorithm>

namespace rubble {

namespace {

/// The number of the leaf at a place behind those of the levels.
std::size_t leafAt(const Asset& asset, std::size_t place) { return place - asset.levels.size() - 1; }

QString tr(const char* text) { return QCoreApplication::translate("PatternPlaces", text); }

}  // namespace

std::size_t patternCount(const Asset& asset) { return 1 + asset.levels.size() + asset.leaves.size(); }

const Level* levelAt(const Asset& asset, std::size_t place) {
    if (place == 0 || place >= patternCount(asset)) return nullptr;
    if (place <= asset.levels.size()) return &asset.levels[place - 1];
    const FragmentLevel& leaf = asset.leaves[leafAt(asset, place)];
    return leaf.level ? &*leaf.level : nullptr;
}

const Pattern* patternAt(const Asset& asset, std::size_t place) {
    if (place == 0) return &asset.pattern;
    const Level* level = levelAt(asset, place);
    return level ? &level->pattern : nullptr;
}

Pattern& patternAt(Asset& asset, std::size_t place) {
    if (place == 0) return asset.pattern;
    if (place <= asset.levels.size()) return asset.levels[place - 1].pattern;
    FragmentLevel& leaf = asset.leaves.at(leafAt(asset, place));
    if (!leaf.level) leaf.level.emplace();
    return leaf.level->pattern;
}

std::size_t placeFor(const Asset& asset, const FragmentPath& fragment) {
    if (fragment.empty()) return 0;
    const auto leaf = std::ranges::find(asset.leaves, fragment, &FragmentLevel::fragment);
    if (leaf != asset.leaves.end())
        return 1 + asset.levels.size() + static_cast<std::size_t>(leaf - asset.leaves.begin());
    const std::size_t level = levelOf(fragment);
    return level < asset.levels.size() ? level + 1 : 0;
}

bool hasOwnPattern(const Asset& asset, const FragmentPath& fragment) {
    const std::size_t place = placeFor(asset, fragment);
    return place > asset.levels.size() && levelAt(asset, place) != nullptr;
}

Pattern& ownPattern(Asset& asset, const FragmentPath& fragment) {
    if (fragment.empty()) return asset.pattern;
    if (!hasOwnPattern(asset, fragment)) {
        const Level* shared = levelFor(asset, fragment, levelOf(fragment));
        const Level own = shared ? *shared : Level{};
        const auto leaf = std::ranges::lower_bound(asset.leaves, fragment, {}, &FragmentLevel::fragment);
        const bool isThere = leaf != asset.leaves.end() && leaf->fragment == fragment;
        (isThere ? leaf : asset.leaves.insert(leaf, {fragment, {}}))->level = own;
    }
    return patternAt(asset, placeFor(asset, fragment));
}

void setMinimumVolume(Asset& asset, std::size_t place, double volume) {
    if (!levelAt(asset, place)) return;
    if (place <= asset.levels.size()) {
        asset.levels[place - 1].minimumVolume = volume;
    } else {
        asset.leaves[leafAt(asset, place)].level->minimumVolume = volume;
    }
}

void removeLevelAt(Asset& asset, std::size_t place) {
    if (place == 0 || place >= patternCount(asset)) return;
    if (place <= asset.levels.size()) {
        asset.levels.erase(asset.levels.begin() + static_cast<std::ptrdiff_t>(place) - 1);
    } else {
        asset.leaves.erase(asset.leaves.begin() + static_cast<std::ptrdiff_t>(leafAt(asset, place)));
    }
}

std::size_t depthAt(const Asset& asset, std::size_t place) {
    if (place <= asset.levels.size() || place >= patternCount(asset)) return place;
    return levelOf(asset.leaves[leafAt(asset, place)].fragment) + 1;
}

QString placeText(const Asset& asset, std::size_t place) {
    if (place == 0) return tr("The whole");
    if (place <= asset.levels.size()) return tr("Fragments, level %1").arg(place);
    const FragmentLevel& leaf = asset.leaves[leafAt(asset, place)];
    const QString name = QString::fromStdString(leaf.fragment);
    return leaf.level ? tr("Fragment %1").arg(name) : tr("Fragment %1, stays whole").arg(name);
}

}  // namespace rubble
