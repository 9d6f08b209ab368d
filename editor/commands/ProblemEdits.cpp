#include "editor/commands/ProblemEdits.h"

#include "core/fracture/SeedEdits.h"
#include "core/geometry/PolygonFaults.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr std::uint32_t kRounds = 3;  // of relaxation that a fix adds

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
    }
    return {};
}

Edit fixed(const Project& project, std::span<const Problem> problems, ProblemFix fix) {
    Edit edit{.text = textOf(fix)};
    std::map<Id, Asset> assets;
    std::set<std::pair<Id, std::uint32_t>> relaxed;
    for (const Problem& problem : problems) {
        if (!canFix(project, problem, fix)) continue;
        Asset& asset = assets.try_emplace(problem.asset, *findAsset(project, problem.asset)).first->second;
        switch (fix) {
            case ProblemFix::DeleteSeed: deleteSeed(asset.pattern, *problem.seed); break;
            case ProblemFix::ForgetChange: restoreSeed(asset.pattern, *problem.seed); break;
            case ProblemFix::DeletePoint: deleteRepeatedPoints(asset.prism.outline); break;
            case ProblemFix::MergePieces: mergeTinyPieces(asset.shaping.smallPieces); break;
            case ProblemFix::Relax: {
                Pattern* pattern = patternOfLevel(asset, problem.level);
                if (pattern && relaxed.insert({asset.id, problem.level}).second) relax(*pattern, project, edit);
                break;
            }
        }
    }
    for (auto& [id, asset] : assets) edit.swaps.push_back(Swap<Asset>{id, std::move(asset)});
    return edit;
}

}  // namespace rubble
