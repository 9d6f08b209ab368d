#include "editor/commands/SelectedSeedEdits.h"

#include "core/fracture/pattern/SeedEdits.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"

#include <QCoreApplication>

#include <algorithm>
#include <ranges>

namespace rubble {

namespace {

struct SelectedSeedEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(SelectedSeedEdits)
};

bool isPlaced(const Pattern& pattern, SeedId seed) {
    const PatternLayer* layer = findLayer(pattern, seed.layer);
    return layer && std::holds_alternative<PlacedSeeds>(layer->parameters);
}

}  // namespace

FragmentSelection::Seeds seedsAmong(const BakedPattern& pattern, const FragmentSelection::Seeds& selected) {
    FragmentSelection::Seeds seeds;
    for (const SeedId id : pattern.seeds.ids) {
        if (selected.contains(id)) seeds.insert(id);
    }
    return seeds;
}

Edit deleteSeeds(Asset asset, const FragmentPath& parent, const FragmentSelection::Seeds& seeds) {
    if (seeds.empty()) return {};
    Pattern& pattern = ownPattern(asset, parent);
    // Overrides are inserted in ascending order and placed seeds erased in descending order, so that little is moved.
    for (const SeedId seed : seeds) {
        if (!isPlaced(pattern, seed)) deleteSeed(pattern, seed);
    }
    for (const SeedId seed : seeds | std::views::reverse) {
        if (isPlaced(pattern, seed)) deleteSeed(pattern, seed);
    }
    const int count = static_cast<int>(seeds.size());
    return modify(SelectedSeedEditsTexts::tr("Delete %n Seed(s)", nullptr, count), std::move(asset));
}

Edit restoreSeeds(Asset asset, const FragmentPath& parent, const FragmentSelection::Seeds& seeds) {
    const Asset before = asset;
    Pattern& pattern = ownPattern(asset, parent);
    if (seeds.empty()) {
        for (PatternLayer& layer : pattern.layers) layer.overrides.clear();
    }
    for (const SeedId seed : seeds) restoreSeed(pattern, seed);
    if (asset == before) return {};
    return modify(SelectedSeedEditsTexts::tr("Restore Seeds"), std::move(asset));
}

}  // namespace rubble
