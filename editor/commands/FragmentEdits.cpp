#include "editor/commands/FragmentEdits.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/geometry/polygon/AreaMoments.h"
#include "core/structure/bonds/FragmentSilhouette.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/CellSelection.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr std::uint32_t kDefaultSeedCount = 5;

struct FragmentEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(FragmentEdits)
};

/// The direction perpendicular to the principal axis of an area.
Vec2 minorAxisOf(const AreaMoments& moments) {
    const double difference = moments.xx - moments.yy;
    const Vec2 along(difference + std::sqrt(difference * difference + 4.0 * moments.xy * moments.xy), 2.0 * moments.xy);
    if (along == Vec2(0.0, 0.0)) return moments.xx >= moments.yy ? Vec2(0.0, 1.0) : Vec2(1.0, 0.0);
    return perpendicular(along / std::sqrt(along.x * along.x + along.y * along.y));
}

FragmentLevel& leafOf(Asset& asset, const FragmentPath& path) {
    const auto position = std::ranges::lower_bound(asset.fragmentLevels, path, {}, &FragmentLevel::fragment);
    if (position != asset.fragmentLevels.end() && position->fragment == path) return *position;
    return *asset.fragmentLevels.insert(position, {path, {}});
}

/// Tests whether edits concern fragments that come from some seeds.
struct EditFilter {
    const std::set<SeedId>& seeds;
    const FragmentPath& parent;  // the fragment that they fracture; empty: the whole asset

    bool matches(const FragmentPath& path) const {
        if (path == parent || !isWithin(path, parent)) return false;
        const std::optional<PieceName> name = pieceNameOf(childOnPath(parent, path));
        return name && seeds.contains(name->seed);
    }
    bool matches(const FragmentLevel& leaf) const { return matches(leaf.fragment); }
    bool matches(const FragmentThreshold& own) const { return matches(own.fragment); }
    bool matches(const FragmentEdit& edit) const {
        if (const auto* split = std::get_if<FragmentSplit>(&edit)) return matches(split->fragment);
        const auto& merge = std::get<FragmentMerge>(edit);
        return matches(merge.into) ||
               std::ranges::any_of(merge.merged, [&](const FragmentPath& path) { return matches(path); });
    }
};

}  // namespace

std::vector<SelectedFragment> selectedFragments(Id asset, const Partition& partition, const Seeds& seeds,
                                                const FragmentSelection& selection, const FragmentPath& parent,
                                                Vec2 offset) {
    const std::string prefix = parent.empty() ? std::string() : parent + "/";
    const std::vector<bool> isSelected = selectedPieces(asset, partition, seeds, selection, parent);
    std::vector<SelectedFragment> fragments;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (!isSelected[piece]) continue;
        const FragmentPath path = prefix + pieceName(partition, piece, seeds.ids);
        const AreaMoments moments = momentsOf(pieceOutline(partition, piece));
        fragments.push_back({path, moments.area, {offset + partition.origin + moments.centre, minorAxisOf(moments)}});
    }
    return fragments;
}

std::vector<SelectedFragment> selectedFragments(const Bake& bake, const FragmentSelection& selection,
                                                const FragmentPath& parent) {
    std::vector<SelectedFragment> fragments;
    for (const std::uint32_t root : rootsOf(bake, fragmentsOf(selection, bake))) {
        const FragmentPath path = bake.fragmentPath(root);
        if (!isWithin(path, parent) || path == parent) continue;
        const Fragment solid = bake.fragment(root).solid;
        const Polygon outline = silhouetteOf(solid);
        fragments.push_back({path, area(outline), splitLine(outline, Vec2{solid.offset()})});
    }
    return fragments;
}

std::vector<SelectedFragment> selectedDescendants(const Bake& bake, const FragmentSelection& selection,
                                                  const FragmentPath& parent) {
    std::vector<SelectedFragment> fragments = selectedFragments(bake, selection, parent);
    std::erase_if(fragments, [&](const SelectedFragment& one) { return parentOf(one.path) == parent; });
    return fragments;
}

Line splitLine(const Polygon& outline, Vec2 origin) {
    const AreaMoments moments = momentsOf(outline);
    return {origin + moments.centre, minorAxisOf(moments)};
}

Edit fractureFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments) {
    Edit edit{.text = FragmentEditsTexts::tr("Fracture Fragments")};
    Asset changed = *findAsset(project, asset);
    for (const SelectedFragment& fragment : fragments) {
        FragmentLevel& leaf = leafOf(changed, fragment.path);
        if (leaf.level) continue;
        const Id layer = edit.allocateId(project);
        leaf.level.emplace();
        leaf.level->pattern.layers = {
            {.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = kDefaultSeedCount}}};
    }
    edit.replacements.push_back(Replacement<Asset>{asset, std::move(changed)});
    return edit;
}

Edit keepFragmentsWhole(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments) {
    Asset changed = *findAsset(project, asset);
    for (const SelectedFragment& fragment : fragments) leafOf(changed, fragment.path).level.reset();
    return modify(FragmentEditsTexts::tr("Keep Fragments Intact"), std::move(changed));
}

Edit mergeFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments) {
    const auto largest = std::ranges::max_element(fragments, {}, &SelectedFragment::area);
    FragmentMerge merge{.into = largest->path, .merged = {}};
    for (const SelectedFragment& fragment : fragments) {
        if (fragment.path != merge.into) merge.merged.push_back(fragment.path);
    }
    Asset changed = *findAsset(project, asset);
    changed.edits.push_back(std::move(merge));
    return modify(FragmentEditsTexts::tr("Merge Fragments"), std::move(changed));
}

Edit splitFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments) {
    Asset changed = *findAsset(project, asset);
    for (const SelectedFragment& fragment : fragments)
        changed.edits.push_back(FragmentSplit{fragment.path, fragment.splitLine});
    return modify(FragmentEditsTexts::tr("Split Fragments"), std::move(changed));
}

void setFragmentThreshold(Asset& asset, const FragmentPath& fragment, std::optional<double> threshold) {
    std::vector<FragmentThreshold>& all = asset.fragmentThresholds;
    const auto place = std::ranges::lower_bound(all, fragment, {}, &FragmentThreshold::fragment);
    const bool exists = place != all.end() && place->fragment == fragment;
    if (threshold) {
        (exists ? place : all.insert(place, {fragment, {}}))->threshold = *threshold;
    } else if (exists) {
        all.erase(place);
    }
}

void setNeverBreaks(Asset& asset, const FragmentPath& fragment, bool neverBreaks) {
    std::vector<FragmentPath>& all = asset.bonding.neverBreaks;
    const auto place = std::ranges::lower_bound(all, fragment);
    const bool exists = place != all.end() && *place == fragment;
    if (neverBreaks && !exists) all.insert(place, fragment);
    if (!neverBreaks && exists) all.erase(place);
}

Edit restoreFragments(const Project& project, Id asset, const std::set<SeedId>& seeds, const FragmentPath& parent) {
    Asset changed = *findAsset(project, asset);
    const EditFilter filter{seeds, parent};
    std::erase_if(changed.edits, [&](const FragmentEdit& edit) { return filter.matches(edit); });
    std::erase_if(changed.fragmentLevels, [&](const FragmentLevel& leaf) { return filter.matches(leaf); });
    std::erase_if(changed.fragmentThresholds, [&](const FragmentThreshold& own) { return filter.matches(own); });
    std::erase_if(changed.bonding.neverBreaks, [&](const FragmentPath& path) { return filter.matches(path); });
    for (FragmentCluster& cluster : changed.bonding.clusters)
        std::erase_if(cluster.fragments, [&](const FragmentPath& path) { return filter.matches(path); });
    sortClusters(changed.bonding.clusters);
    return modify(FragmentEditsTexts::tr("Restore Fragments"), std::move(changed));
}

bool canRestoreFragments(const Asset& asset, const std::set<SeedId>& seeds, const FragmentPath& parent) {
    const EditFilter filter{seeds, parent};
    const auto matches = [&](const auto& setting) { return filter.matches(setting); };
    return std::ranges::any_of(asset.edits, matches) || std::ranges::any_of(asset.fragmentLevels, matches) ||
           std::ranges::any_of(asset.fragmentThresholds, matches) ||
           std::ranges::any_of(asset.bonding.neverBreaks, matches) ||
           std::ranges::any_of(asset.bonding.clusters, [&](const FragmentCluster& cluster) {
               return std::ranges::any_of(cluster.fragments, matches);
           });
}

}  // namespace rubble
