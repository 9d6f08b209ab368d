#include "editor/commands/AssetPatterns.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/project/AssetShape.h"
#include "core/asset/project/FragmentLevels.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kTypicalFragmentSize = 0.25;  // of the length of its parent

/// The position in Asset::fragmentLevels of a pattern index behind those of the levels.
std::size_t leafAt(const Asset& asset, std::size_t index) { return index - asset.levels.size() - 1; }

/// Null where levelAt() is.
Level* mutableLevelAt(Asset& asset, std::size_t index) {
    if (levelAt(asset, index) == nullptr) return nullptr;
    return index <= asset.levels.size() ? &asset.levels[index - 1] : &*asset.fragmentLevels[leafAt(asset, index)].level;
}

struct AssetPatternsTexts {
    Q_DECLARE_TR_FUNCTIONS(AssetPatterns)
};

}  // namespace

std::size_t patternCount(const Asset& asset) { return 1 + asset.levels.size() + asset.fragmentLevels.size(); }

const Level* levelAt(const Asset& asset, std::size_t index) {
    if (index == 0 || index >= patternCount(asset)) return nullptr;
    if (index <= asset.levels.size()) return &asset.levels[index - 1];
    const FragmentLevel& leaf = asset.fragmentLevels[leafAt(asset, index)];
    return leaf.level ? &*leaf.level : nullptr;
}

const Pattern* patternAt(const Asset& asset, std::size_t index) {
    if (index == 0) return &asset.pattern;
    const Level* level = levelAt(asset, index);
    return level ? &level->pattern : nullptr;
}

Pattern& patternAt(Asset& asset, std::size_t index) {
    if (index == 0) return asset.pattern;
    if (index <= asset.levels.size()) return asset.levels[index - 1].pattern;
    FragmentLevel& leaf = asset.fragmentLevels.at(leafAt(asset, index));
    if (!leaf.level) leaf.level.emplace();
    return leaf.level->pattern;
}

std::size_t patternIndexFor(const Asset& asset, const FragmentPath& fragment) {
    if (fragment.empty()) return 0;
    const auto leaf = std::ranges::find(asset.fragmentLevels, fragment, &FragmentLevel::fragment);
    if (leaf != asset.fragmentLevels.end())
        return 1 + asset.levels.size() + static_cast<std::size_t>(leaf - asset.fragmentLevels.begin());
    const std::size_t level = levelOf(fragment);
    return level < asset.levels.size() ? level + 1 : 0;
}

bool hasOwnPattern(const Asset& asset, const FragmentPath& fragment) {
    const std::size_t index = patternIndexFor(asset, fragment);
    return index > asset.levels.size() && levelAt(asset, index) != nullptr;
}

Pattern& ownPattern(Asset& asset, const FragmentPath& fragment) {
    if (fragment.empty()) return asset.pattern;
    if (!hasOwnPattern(asset, fragment)) {
        const Level* shared = levelFor(asset, fragment, levelOf(fragment));
        const Level own = shared ? *shared : Level{};
        const auto leaf = std::ranges::lower_bound(asset.fragmentLevels, fragment, {}, &FragmentLevel::fragment);
        const bool exists = leaf != asset.fragmentLevels.end() && leaf->fragment == fragment;
        (exists ? leaf : asset.fragmentLevels.insert(leaf, {fragment, {}}))->level = own;
    }
    return patternAt(asset, patternIndexFor(asset, fragment));
}

void setMinimumVolume(Asset& asset, std::size_t index, double volume) {
    if (Level* level = mutableLevelAt(asset, index)) level->minimumVolume = volume;
}

void setLevelThreshold(Asset& asset, std::size_t index, std::optional<double> threshold) {
    if (Level* level = mutableLevelAt(asset, index)) level->threshold = threshold;
}

void setBondStrength(Asset& asset, std::size_t index, double strength) {
    if (Level* level = mutableLevelAt(asset, index)) level->bondStrength = strength;
}

void removeLevelAt(Asset& asset, std::size_t index) {
    if (index == 0 || index >= patternCount(asset)) return;
    if (index <= asset.levels.size()) {
        asset.levels.erase(asset.levels.begin() + static_cast<std::ptrdiff_t>(index) - 1);
    } else {
        asset.fragmentLevels.erase(asset.fragmentLevels.begin() + static_cast<std::ptrdiff_t>(leafAt(asset, index)));
    }
}

std::size_t depthAt(const Asset& asset, std::size_t index) {
    if (index <= asset.levels.size() || index >= patternCount(asset)) return index;
    return levelOf(asset.fragmentLevels[leafAt(asset, index)].fragment) + 1;
}

Box2 domainBounds(const Asset& asset, std::size_t index) {
    const Box2 bounds = planeBoundsOf(asset);
    if (index == 0) return bounds;
    const auto depth = static_cast<double>(depthAt(asset, index));
    const Vec2 half = bounds.size() / 2.0 * std::pow(kTypicalFragmentSize, depth);
    return {-half, half};
}

Box3 domainBox(const Asset& asset, std::size_t index) {
    const ClosedMesh* mesh = asset.mesh();
    if (!mesh) {
        const Box2 bounds = domainBounds(asset, index);
        return boxOf(bounds.min, bounds.max);
    }
    if (index == 0) return mesh->bounds;
    const auto depth = static_cast<double>(depthAt(asset, index));
    const Vec3 half = (mesh->bounds.max - mesh->bounds.min) / 2.0 * std::pow(kTypicalFragmentSize, depth);
    return {-half, half};
}

QString patternName(const Asset& asset, std::size_t index) {
    if (index == 0) return AssetPatternsTexts::tr("Intact asset");
    if (index <= asset.levels.size()) return AssetPatternsTexts::tr("Fragments, level %1").arg(index);
    const FragmentLevel& leaf = asset.fragmentLevels[leafAt(asset, index)];
    const QString name = nameText(leaf.fragment);
    return leaf.level ? AssetPatternsTexts::tr("Fragment %1").arg(name)
                      : AssetPatternsTexts::tr("Fragment %1, kept intact").arg(name);
}

}  // namespace rubble
