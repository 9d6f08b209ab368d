#include "editor/commands/FragmentEdits.h"

#include "core/asset/FragmentPlace.h"
#include "core/fracture/PatternPartition.h"
#include "core/geometry/AreaMoments.h"
#include "editor/commands/ProjectEdits.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr std::uint32_t kSeedsOfFragment = 5;

QString tr(const char* text) { return QCoreApplication::translate("FragmentEdits", text); }

/// The direction across the way along which an area is spread farthest.
Vec2 acrossOf(const AreaMoments& moments) {
    const double difference = moments.xx - moments.yy;
    const Vec2 along(difference + std::sqrt(difference * difference + 4.0 * moments.xy * moments.xy), 2.0 * moments.xy);
    if (along == Vec2(0.0, 0.0)) return moments.xx >= moments.yy ? Vec2(0.0, 1.0) : Vec2(1.0, 0.0);
    return perpendicular(along / std::sqrt(along.x * along.x + along.y * along.y));
}

FragmentLevel& leafOf(Asset& asset, const FragmentPath& path) {
    const auto place = std::ranges::lower_bound(asset.leaves, path, {}, &FragmentLevel::fragment);
    if (place != asset.leaves.end() && place->fragment == path) return *place;
    return *asset.leaves.insert(place, {path, {}});
}

/// Finds what is said of fragments that come from some seeds.
struct FromSeeds {
    const std::set<SeedId>& seeds;
    const FragmentPath& inside;  // the fragment that they break; empty: the whole

    bool holds(const FragmentPath& path) const {
        if (path == inside || !isWithin(path, inside)) return false;
        const std::optional<PieceName> name = pieceNameOf(pieceOf(inside, path));
        return name && seeds.contains(name->seed);
    }
    bool holds(const FragmentLevel& leaf) const { return holds(leaf.fragment); }
    bool holds(const FragmentEdit& edit) const {
        if (const auto* split = std::get_if<FragmentSplit>(&edit)) return holds(split->fragment);
        const auto& merge = std::get<FragmentMerge>(edit);
        return holds(merge.into) ||
               std::ranges::any_of(merge.merged, [&](const FragmentPath& path) { return holds(path); });
    }
};

}  // namespace

std::vector<ChosenPiece> chosenPieces(const Partition& partition, const Seeds& seeds, const std::set<SeedId>& chosen,
                                      const FragmentPath& inside, Vec2 offset) {
    const std::string parent = inside.empty() ? std::string() : inside + "/";
    std::vector<ChosenPiece> pieces;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (!chosen.contains(cellId(partition, piece, seeds.ids))) continue;
        const AreaMoments moments = momentsOf(pieceOutline(partition, piece));
        pieces.push_back({parent + pieceName(partition, piece, seeds.ids),
                          moments.area,
                          {offset + partition.origin + moments.centre, acrossOf(moments)}});
    }
    return pieces;
}

Line lineAcross(const Polygon& outline, Vec2 origin) {
    const AreaMoments moments = momentsOf(outline);
    return {origin + moments.centre, acrossOf(moments)};
}

Edit fractureFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces) {
    Edit edit{.text = tr("Fracture fragments")};
    Asset changed = *findAsset(project, asset);
    for (const ChosenPiece& piece : pieces) {
        FragmentLevel& leaf = leafOf(changed, piece.path);
        if (leaf.level) continue;
        const Id layer = edit.takeId(project);
        leaf.level.emplace();
        leaf.level->pattern.layers = {
            {.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = kSeedsOfFragment}}};
    }
    edit.swaps.push_back(Swap<Asset>{asset, std::move(changed)});
    return edit;
}

Edit keepFragmentsWhole(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces) {
    Asset changed = *findAsset(project, asset);
    for (const ChosenPiece& piece : pieces) leafOf(changed, piece.path).level.reset();
    return altered(tr("Keep fragments whole"), std::move(changed));
}

Edit mergeFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces) {
    const auto largest = std::ranges::max_element(pieces, {}, &ChosenPiece::area);
    FragmentMerge merge{.into = largest->path, .merged = {}};
    for (const ChosenPiece& piece : pieces) {
        if (piece.path != merge.into) merge.merged.push_back(piece.path);
    }
    Asset changed = *findAsset(project, asset);
    changed.edits.push_back(std::move(merge));
    return altered(tr("Merge fragments"), std::move(changed));
}

Edit splitFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces) {
    Asset changed = *findAsset(project, asset);
    for (const ChosenPiece& piece : pieces) changed.edits.push_back(FragmentSplit{piece.path, piece.across});
    return altered(tr("Split fragments"), std::move(changed));
}

Edit restoreFragments(const Project& project, Id asset, const std::set<SeedId>& seeds, const FragmentPath& inside) {
    Asset changed = *findAsset(project, asset);
    const FromSeeds from{seeds, inside};
    std::erase_if(changed.edits, [&](const FragmentEdit& edit) { return from.holds(edit); });
    std::erase_if(changed.leaves, [&](const FragmentLevel& leaf) { return from.holds(leaf); });
    return altered(tr("Restore fragments"), std::move(changed));
}

bool areRestorable(const Asset& asset, const std::set<SeedId>& seeds, const FragmentPath& inside) {
    const FromSeeds from{seeds, inside};
    return std::ranges::any_of(asset.edits, [&](const FragmentEdit& edit) { return from.holds(edit); }) ||
           std::ranges::any_of(asset.leaves, [&](const FragmentLevel& leaf) { return from.holds(leaf); });
}

}  // namespace rubble
