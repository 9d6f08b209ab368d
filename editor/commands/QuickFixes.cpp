#include "editor/commands/QuickFixes.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/bake/SolidShaping.h"
#include "core/asset/project/FragmentLevels.h"
#include "core/asset/strength/Threshold.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/structure/bonds/FragmentSilhouette.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/FragmentEdits.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr std::uint32_t kRelaxationRounds = 3;  // added by a fix
constexpr int kMaxMergeRounds = 16;             // each raises the limit of small pieces
constexpr double kAboveLimit = 1.001;           // pieces exactly at the limit are kept
constexpr int kMaxSplitRounds = 8;              // of a fragment and its parts: at most 256 parts

struct QuickFixesTexts {
    Q_DECLARE_TR_FUNCTIONS(QuickFixes)
};

/// The first point of an outline that repeats the previous one.
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

/// Adds rounds to the relaxation if that is the last layer, or appends a relaxation layer.
void relax(Pattern& pattern, const Project& project, Edit& edit) {
    if (!pattern.layers.empty() && pattern.layers.back().isOn) {
        if (auto* last = std::get_if<LloydRelaxation>(&pattern.layers.back().parameters)) {
            last->rounds += kRelaxationRounds;
            return;
        }
    }
    const Id id = edit.allocateId(project);
    pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = LloydRelaxation{kRelaxationRounds}});
}

/// The limit in the measure of `small` at which the largest tiny fragment is not too small; 0 if none is tiny. Merging
/// measures pieces without the gap, which takes most of a tiny one.
double limitOfTinyFragments(const Asset& asset, const Bake& baked, SmallPieces small) {
    small.limit = 1.0;
    double limit = 0.0;
    for (const Diagnostic& problem : problemsOf(asset, baked, {.most = baked.fragmentCount()})) {
        if (problem.code != DiagnosticCode::TinyPiece) continue;
        const Fragment solid = baked.fragment(problem.place.fragment).solid;
        const std::optional<ExtrudedFragment> extruded = solid.extruded();
        if (!extruded) {
            const double whole = baked.whole.volume;
            const std::uint32_t siblings = solid.all().count();
            limit = std::max(limit, solid.volume() / minFragmentVolume(small, whole, siblings));
            continue;
        }
        const Partition& pieces = solid.all().extruded()->partition;
        const std::vector<double> areas = pieceAreas(pieces);
        const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
        limit = std::max(limit,
                         areas[extruded->piece()] / minPieceArea(small, whole, pieces.pieceCount(), extruded->depth()));
    }
    return limit;
}

/// Merges small pieces, with a limit that leaves no tiny fragment. Merging raises the mean volume, so that a limit may
/// have to be raised several times.
void mergeTinyFragments(Asset& asset, const TaskContext& task) {
    SmallPieces& small = asset.shaping.smallPieces;
    if (small.rule == SmallPieceRule::Keep)
        small = {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, ProblemLimits{}.meanShare};
    for (int round = 0; round < kMaxMergeRounds; ++round) {
        const Result<Bake> baked = bake(asset, task);
        if (!baked) return;
        const double limit = limitOfTinyFragments(asset, *baked, small);
        if (limit == 0.0) return;
        const bool isFraction =
            small.measure == PieceMeasure::FractionOfMean || small.measure == PieceMeasure::FractionOfWhole;
        small.limit = std::max(small.limit, limit) * kAboveLimit;
        if (isFraction) small.limit = std::min(small.limit, 1.0);
    }
}

/// The layer that a problem reports as having too little room; null for other problems.
const PatternLayer* crowdedLayer(const Asset& asset, const Diagnostic& problem) {
    const Pattern* pattern = patternAt(asset, patternIndexFor(asset, problem.place.path));
    return problem.code == DiagnosticCode::NoRoom && pattern ? findLayer(*pattern, problem.place.layer) : nullptr;
}

bool canReduceCount(const LayerParameters& parameters) {
    return std::holds_alternative<BlueNoise>(parameters) || std::holds_alternative<DensityImage>(parameters) ||
           std::holds_alternative<Clusters>(parameters);
}

/// The indices of cluster seeds that do not fit into an outline, without those deleted by hand.
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

/// The outline and pattern of a fracture; its layers have the random seeds that are used there.
struct FracturedOutline {
    Polygon outline;
    Pattern pattern;
};
std::optional<FracturedOutline> fracturedOutline(const Asset& asset, const FragmentPath& parent,
                                                 const TaskContext& task) {
    if (!asset.isPrism()) return std::nullopt;
    if (parent.empty()) return FracturedOutline{asset.prism().outline, asset.pattern};
    const Level* level = levelFor(asset, parent, levelOf(parent));
    const Result<Bake> baked = bake(asset, task);
    if (!baked || !level) return std::nullopt;
    const std::uint32_t fragment = fragmentAt(*baked, parent).value_or(kNone);
    if (fragment == kNone) return std::nullopt;
    return FracturedOutline{baked->fragment(fragment).solid.extruded()->outline(),
                            patternFor(baked->fragmentId(fragment), level->pattern)};
}

/// Reduces the count of a layer to the seeds that fit. A fragment with the pattern of its level gets its own copy
/// first, so that the other fragments stay as they are.
void reduceCount(Asset& asset, const Diagnostic& problem, const TaskContext& task) {
    std::set<std::uint32_t> without;
    if (std::holds_alternative<Clusters>(crowdedLayer(asset, problem)->parameters)) {
        const std::optional<FracturedOutline> fractured = fracturedOutline(asset, problem.place.path, task);
        if (fractured)
            without = seedsWithoutRoom(*findLayer(fractured->pattern, problem.place.layer), fractured->outline);
        if (without.empty()) return;
    }
    Pattern& pattern = ownPattern(asset, problem.place.path);
    // A smaller count does not tell which seeds of a cluster fit, so the others are deleted one by one.
    for (const std::uint32_t seed : without) deleteSeed(pattern, {problem.place.layer, seed});
    LayerParameters& parameters = findLayer(pattern, problem.place.layer)->parameters;
    const auto found = static_cast<std::uint32_t>(problem.value);
    if (auto* noise = std::get_if<BlueNoise>(&parameters)) noise->count = found;
    if (auto* image = std::get_if<DensityImage>(&parameters)) image->count = found;
}

/// Splits fragments and their parts in two until none needs more hulls than the limit of the check.
void splitRepeatedly(Asset& asset, const std::set<FragmentPath>& fragments, const TaskContext& task) {
    std::set<FragmentPath> parents, others;
    for (const FragmentPath& fragment : fragments) parents.insert(parentOf(fragment));
    for (int round = 0; round < kMaxSplitRounds; ++round) {
        const Result<Bake> baked = bake(asset, task);
        if (!baked) return;
        const std::size_t before = asset.edits.size();
        for (std::uint32_t k = 0; k < baked->fragmentCount(); ++k) {
            if (task.isCancelled()) return;
            FragmentPath path = baked->fragmentPath(k);
            if (round == 0 && !fragments.contains(path)) {
                others.insert(std::move(path));  // siblings that appear in later rounds are parts of `fragments`
            } else if (!others.contains(path) && parents.contains(parentOf(path))) {
                const Fragment solid = baked->fragment(k).solid;
                if (solid.isConvex() || solid.hulls().size() <= ProblemLimits{}.hulls) continue;
                asset.edits.push_back(FragmentSplit{path, splitLine(silhouetteOf(solid), Vec2{solid.offset()})});
            }
        }
        if (asset.edits.size() == before) return;
    }
}

bool isOfSeed(DiagnosticCode kind) {
    return kind == DiagnosticCode::DuplicateSeed || kind == DiagnosticCode::SeedWithoutCell ||
           kind == DiagnosticCode::ThinPiece || kind == DiagnosticCode::Sliver || kind == DiagnosticCode::TinyPiece;
}

}  // namespace

bool canFix(const Project& project, const Diagnostic& problem, QuickFix fix) {
    const Asset* asset = findAsset(project, problem.place.asset);
    if (!asset) return false;
    switch (fix) {
        // A deeper level's pattern fractures many fragments: deleting a seed would change all of them.
        case QuickFix::DeleteSeed: return isOfSeed(problem.code) && seedOf(problem.place) && problem.place.level == 0;
        case QuickFix::RemoveOverride: return problem.code == DiagnosticCode::LostOverride && seedOf(problem.place);
        case QuickFix::DeletePoint:
            return problem.code == DiagnosticCode::FaultyOutline && asset->isPrism() &&
                   repeatedPoint(asset->prism().outline);
        case QuickFix::Relax:
            return problem.code == DiagnosticCode::Sliver || problem.code == DiagnosticCode::TinyPiece;
        case QuickFix::MergeTinyFragments: return problem.code == DiagnosticCode::TinyPiece;
        case QuickFix::ReduceCount: {
            const PatternLayer* layer = crowdedLayer(*asset, problem);
            return layer && canReduceCount(layer->parameters);
        }
        case QuickFix::SplitFragment: return problem.code == DiagnosticCode::ManyHulls;
        case QuickFix::KeepEnteredThreshold:
            return problem.code == DiagnosticCode::UnknownStrength && asset->contactTime;
    }
    return false;
}

QString textOf(QuickFix fix) {
    switch (fix) {
        case QuickFix::DeleteSeed: return QuickFixesTexts::tr("Delete Seed");
        case QuickFix::RemoveOverride: return QuickFixesTexts::tr("Remove Override");
        case QuickFix::DeletePoint: return QuickFixesTexts::tr("Delete Point");
        case QuickFix::Relax: return QuickFixesTexts::tr("Relax");
        case QuickFix::MergeTinyFragments: return QuickFixesTexts::tr("Merge Tiny Fragments");
        case QuickFix::ReduceCount: return QuickFixesTexts::tr("Reduce Count to Fit");
        case QuickFix::SplitFragment: return QuickFixesTexts::tr("Split Fragment");
        case QuickFix::KeepEnteredThreshold: return QuickFixesTexts::tr("Keep Entered Threshold");
    }
    return {};
}

QString descriptionOf(QuickFix fix) {
    switch (fix) {
        case QuickFix::DeleteSeed:
            return QuickFixesTexts::tr("Delete the seed and let the neighbouring cells fill its place");
        case QuickFix::RemoveOverride:
            return QuickFixesTexts::tr("Remove the manual change to a seed that no longer exists");
        case QuickFix::DeletePoint: return QuickFixesTexts::tr("Delete repeated points of the outline");
        case QuickFix::Relax:
            return QuickFixesTexts::tr("Add a relaxation that moves scattered seeds to the centres of their cells");
        case QuickFix::MergeTinyFragments:
            return QuickFixesTexts::tr(
                "Merge each tiny fragment of the asset into the neighbour with the longest shared edge");
        case QuickFix::ReduceCount:
            return QuickFixesTexts::tr("Reduce the count of the layer to the seeds that fit, which stay in place");
        case QuickFix::SplitFragment:
            return QuickFixesTexts::tr(
                "Split the fragment across its longest dimension until each part needs few convex hulls");
        case QuickFix::KeepEnteredThreshold:
            return QuickFixesTexts::tr("Use the entered threshold and stop deriving it from the tensile strength");
    }
    return {};
}

bool isSlow(QuickFix fix) {
    return fix == QuickFix::SplitFragment || fix == QuickFix::ReduceCount || fix == QuickFix::MergeTinyFragments;
}

Edit applyFix(const Project& project, std::span<const Diagnostic> problems, QuickFix fix, const TaskContext& task) {
    Edit edit{.text = textOf(fix)};
    std::map<Id, Asset> assets;
    std::set<std::pair<Id, std::uint32_t>> relaxed;
    std::map<Id, std::set<FragmentPath>> split;
    std::set<Id> merged;
    for (const Diagnostic& problem : problems) {
        if (!canFix(project, problem, fix)) continue;
        Asset& asset = assets.try_emplace(problem.place.asset, *findAsset(project, problem.place.asset)).first->second;
        switch (fix) {
            case QuickFix::DeleteSeed: deleteSeed(asset.pattern, *seedOf(problem.place)); break;
            case QuickFix::RemoveOverride: restoreSeed(asset.pattern, *seedOf(problem.place)); break;
            case QuickFix::DeletePoint: deleteRepeatedPoints(asset.prism().outline); break;
            case QuickFix::MergeTinyFragments: merged.insert(problem.place.asset); break;
            case QuickFix::ReduceCount: reduceCount(asset, problem, task); break;
            case QuickFix::SplitFragment: split[problem.place.asset].insert(problem.place.path); break;
            case QuickFix::KeepEnteredThreshold: enterThreshold(asset, asset.threshold); break;
            case QuickFix::Relax: {
                Pattern* pattern = patternOfLevel(asset, problem.place.level);
                if (pattern && relaxed.insert({asset.id, problem.place.level}).second) relax(*pattern, project, edit);
                break;
            }
        }
    }
    for (const auto& [id, fragments] : split) splitRepeatedly(assets.at(id), fragments, task);
    for (const Id id : merged) mergeTinyFragments(assets.at(id), task);
    if (task.isCancelled()) return Edit{.text = edit.text};
    for (auto& [id, asset] : assets) edit.replacements.push_back(Replacement<Asset>{id, std::move(asset)});
    return edit;
}

}  // namespace rubble
