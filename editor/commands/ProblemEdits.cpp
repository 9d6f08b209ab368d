#include "editor/commands/ProblemEdits.h"

#include "core/asset/Breaking.h"
#include "core/asset/FragmentPlace.h"
#include "core/fracture/PairIndex.h"
#include "core/fracture/SeedEdits.h"
#include "core/geometry/PolygonFaults.h"
#include "editor/commands/FragmentEdits.h"
#include "editor/commands/PatternPlaces.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr std::uint32_t kRounds = 3;  // of relaxation that a fix adds
constexpr int kMostCuts = 8;          // of a piece and its parts, which are 256 then

QString tr(const char* text) { return QCoreApplication::translate("ProblemEdits", text); }

/// The first point of an outline that repeats the one before it.
std::optional<RingPoint> repeatedPoint(const Polygon& outline) {
    for (const PolygonFault& fault : polygonFaults(outline)) {
        if (fault.kind == PolygonFaultKind::RepeatedPoint) return fault.first;
    }
    return std::nullopt;
}

void deleteRepeatedPoints(Polygon& outline) {
    while (const std::optional<RingPoint> point = repeatedPoint(outline)) {
        Ring& ring = point->ring == 0 ? outline.outer : outline.holes[static_cast<std::size_t>(point->ring - 1)];
        ring.erase(ring.begin() + point->point);
    }
}

Pattern* patternOfLevel(Asset& asset, std::uint32_t level) {
    if (level == 0) return &asset.pattern;
    return level <= asset.levels.size() ? &asset.levels[level - 1].pattern : nullptr;
}

/// More rounds for the relaxation that comes last, or one at the end.
void relax(Pattern& pattern, const Project& project, Edit& edit) {
    if (!pattern.layers.empty() && pattern.layers.back().isOn) {
        if (auto* last = std::get_if<LloydRelaxation>(&pattern.layers.back().parameters)) {
            last->rounds += kRounds;
            return;
        }
    }
    const Id id = edit.takeId(project);
    pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = LloydRelaxation{kRounds}});
}

/// Merged by the limit below which pieces are told of; the mean of what is left is above that of what there is, so none stays.
void mergeTinyPieces(SmallPieces& small) {
    if (small.rule == SmallPieceRule::Keep) small.rule = SmallPieceRule::Merge;
    small.measure = PieceMeasure::PartOfMean;
    small.limit = ProblemLimits{}.meanShare;
}

/// The layer of a pattern that found no room.
const PatternLayer* crowdedLayer(const Asset& asset, const Problem& problem) {
    const Pattern* pattern = patternAt(asset, placeFor(asset, problem.path));
    return problem.kind == ProblemKind::NoRoom && pattern ? findLayer(*pattern, problem.layer) : nullptr;
}

bool canAskForFewer(const LayerParameters& parameters) {
    return std::holds_alternative<BlueNoise>(parameters) || std::holds_alternative<DensityImage>(parameters) ||
           std::holds_alternative<Clusters>(parameters);
}

/// The seeds of clusters that find no room in an outline, by index; those deleted by hand need none.
std::set<std::uint32_t> seedsWithoutRoom(const PatternLayer& layer, const Polygon& outline) {
    const Clusters& clusters = std::get<Clusters>(layer.parameters);
    std::set<std::uint32_t> missing;
    for (const IndexPair pair : pairsBelow(clusters.clusters, clusters.seedsPerCluster)) missing.insert(pair.index());
    for (const SeedOverride& change : layer.overrides) {
        if (change.isDeleted) missing.erase(change.index);
    }
    if (const Result<Seeds> seeds = seedsOf(Pattern{{layer}}, outline)) {
        for (const SeedId id : seeds->ids) missing.erase(id.index);
    }
    return missing;
}

/// What is broken somewhere, and the layers that break it, with the random seeds that they have there.
struct BrokenPlace {
    Polygon outline;
    Pattern pattern;
};
std::optional<BrokenPlace> brokenPlace(const Asset& asset, const FragmentPath& place, const TaskContext& task) {
    if (place.empty()) return BrokenPlace{asset.prism.outline, asset.pattern};
    const Level* level = levelFor(asset, place, levelOf(place));
    const Result<Bake> baked = bake(asset, task);
    if (!baked || !level) return std::nullopt;
    const std::uint32_t fragment = fragmentAt(*baked, place).value_or(kNone);
    if (fragment == kNone) return std::nullopt;
    return BrokenPlace{baked->fragment(fragment).solid.outline(),
                       patternFor(baked->fragmentId(fragment), level->pattern)};
}

/// Lets a layer ask for the seeds that find room. Of a fragment of a level it gets a pattern of its own, so that others break as before.
void askForFewer(Asset& asset, const Problem& problem, const TaskContext& task) {
    std::set<std::uint32_t> without;
    if (std::holds_alternative<Clusters>(crowdedLayer(asset, problem)->parameters)) {
        const std::optional<BrokenPlace> place = brokenPlace(asset, problem.path, task);
        if (place) without = seedsWithoutRoom(*findLayer(place->pattern, problem.layer), place->outline);
        if (without.empty()) return;
    }
    Pattern& pattern = ownPattern(asset, problem.path);
    // Which seeds of a heap find no room is not a matter of how many there are.
    for (const std::uint32_t seed : without) deleteSeed(pattern, {problem.layer, seed});
    LayerParameters& parameters = findLayer(pattern, problem.layer)->parameters;
    const auto found = static_cast<std::uint32_t>(problem.value);
    if (auto* noise = std::get_if<BlueNoise>(&parameters)) noise->count = found;
    if (auto* image = std::get_if<DensityImage>(&parameters)) image->count = found;
}

/// Cuts pieces in two, and their parts again, until each takes no more hulls than are usual.
void cutApart(Asset& asset, const std::set<FragmentPath>& pieces, const TaskContext& task) {
    std::set<FragmentPath> places, others;
    for (const FragmentPath& piece : pieces) places.insert(parentOf(piece));
    for (int round = 0; round < kMostCuts; ++round) {
        const Result<Bake> baked = bake(asset, task);
        if (!baked) return;
        const std::size_t before = asset.edits.size();
        for (std::uint32_t k = 0; k < baked->fragmentCount(); ++k) {
            if (task.isCancelled()) return;
            FragmentPath path = pathOfId(baked->fragmentId(k));
            if (round == 0 && !pieces.contains(path)) {
                others.insert(std::move(path));  // what has another name later is a part of ours
            } else if (!others.contains(path) && places.contains(parentOf(path))) {
                const Fragment solid = baked->fragment(k).solid;
                if (solid.isConvex() || solid.hulls().size() <= ProblemLimits{}.hulls) continue;
                asset.edits.push_back(FragmentSplit{path, lineAcross(solid.outline(), Vec2{solid.offset()})});
            }
        }
        if (asset.edits.size() == before) return;
    }
}

bool isOfSeed(ProblemKind kind) {
    return kind == ProblemKind::DuplicateSeed || kind == ProblemKind::SeedWithoutCell ||
           kind == ProblemKind::ThinPiece || kind == ProblemKind::Sliver || kind == ProblemKind::TinyPiece;
}

}  // namespace

bool canFix(const Project& project, const Problem& problem, ProblemFix fix) {
    const Asset* asset = findAsset(project, problem.asset);
    if (!asset) return false;
    switch (fix) {
        // Patterns of deeper levels break many fragments: a seed of one is a seed of all.
        case ProblemFix::DeleteSeed: return isOfSeed(problem.kind) && problem.seed && problem.level == 0;
        case ProblemFix::ForgetChange: return problem.kind == ProblemKind::LostOverride && problem.seed;
        case ProblemFix::DeletePoint:
            return problem.kind == ProblemKind::FaultyOutline && repeatedPoint(asset->prism.outline);
        case ProblemFix::Relax: return problem.kind == ProblemKind::Sliver || problem.kind == ProblemKind::TinyPiece;
        case ProblemFix::MergePieces: return problem.kind == ProblemKind::TinyPiece;
        case ProblemFix::AskForFewer: {
            const PatternLayer* layer = crowdedLayer(*asset, problem);
            return layer && canAskForFewer(layer->parameters);
        }
        case ProblemFix::CutApart: return problem.kind == ProblemKind::ManyHulls;
        case ProblemFix::KeepTyped: return problem.kind == ProblemKind::UnknownStrength && asset->contactTime;
    }
    return false;
}

QString textOf(ProblemFix fix) {
    switch (fix) {
        case ProblemFix::DeleteSeed: return tr("Delete Seed");
        case ProblemFix::ForgetChange: return tr("Forget Change");
        case ProblemFix::DeletePoint: return tr("Delete Point");
        case ProblemFix::Relax: return tr("Relax");
        case ProblemFix::MergePieces: return tr("Merge Tiny Pieces");
        case ProblemFix::AskForFewer: return tr("Ask for as Many as Fit");
        case ProblemFix::CutApart: return tr("Cut Apart");
        case ProblemFix::KeepTyped: return tr("Keep Typed Threshold");
    }
    return {};
}

QString hintOf(ProblemFix fix) {
    switch (fix) {
        case ProblemFix::DeleteSeed: return tr("Delete the seed; the cells around take the place of its own");
        case ProblemFix::ForgetChange: return tr("Forget what was done by hand to a seed that is not there any more");
        case ProblemFix::DeletePoint: return tr("Delete the points of the outline that repeat the one before them");
        case ProblemFix::Relax:
            return tr(
                "Let the pattern end with a relaxation, which moves scattered seeds to the middles of their cells");
        case ProblemFix::MergePieces:
            return tr(
                "Let all pieces of the asset that are as small go into the neighbour with the longest shared edge");
        case ProblemFix::AskForFewer:
            return tr(
                "Set the counts of the layer to seeds that find room; they stay. A fragment gets a pattern of its own");
        case ProblemFix::CutApart:
            return tr("Split the piece across its longest way, and its parts again, until each needs few hulls");
        case ProblemFix::KeepTyped:
            return tr("Let the threshold be the typed number, which is in force, and no longer follow from strength");
    }
    return {};
}

bool isLong(ProblemFix fix) { return fix == ProblemFix::CutApart || fix == ProblemFix::AskForFewer; }

Edit fixed(const Project& project, std::span<const Problem> problems, ProblemFix fix, const TaskContext& task) {
    Edit edit{.text = textOf(fix)};
    std::map<Id, Asset> assets;
    std::set<std::pair<Id, std::uint32_t>> relaxed;
    std::map<Id, std::set<FragmentPath>> bent;
    for (const Problem& problem : problems) {
        if (!canFix(project, problem, fix)) continue;
        Asset& asset = assets.try_emplace(problem.asset, *findAsset(project, problem.asset)).first->second;
        switch (fix) {
            case ProblemFix::DeleteSeed: deleteSeed(asset.pattern, *problem.seed); break;
            case ProblemFix::ForgetChange: restoreSeed(asset.pattern, *problem.seed); break;
            case ProblemFix::DeletePoint: deleteRepeatedPoints(asset.prism.outline); break;
            case ProblemFix::MergePieces: mergeTinyPieces(asset.shaping.smallPieces); break;
            case ProblemFix::AskForFewer: askForFewer(asset, problem, task); break;
            case ProblemFix::CutApart: bent[problem.asset].insert(problem.path); break;
            case ProblemFix::KeepTyped: asset.contactTime.reset(); break;
            case ProblemFix::Relax: {
                Pattern* pattern = patternOfLevel(asset, problem.level);
                if (pattern && relaxed.insert({asset.id, problem.level}).second) relax(*pattern, project, edit);
                break;
            }
        }
    }
    for (const auto& [id, pieces] : bent) cutApart(assets.at(id), pieces, task);
    if (task.isCancelled()) return Edit{.text = edit.text};
    for (auto& [id, asset] : assets) edit.swaps.push_back(Swap<Asset>{id, std::move(asset)});
    return edit;
}

}  // namespace rubble
