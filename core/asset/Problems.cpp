#include "core/asset/Problems.h"

#include "core/asset/Breaking.h"
#include "core/asset/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/fracture/PatternPartition.h"
#include "core/geometry/Aspect.h"
#include "core/geometry/PolygonFaults.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace rubble {
namespace {

constexpr int kDigits = 3;  // of figures in sentences

std::optional<ProblemKind> kindOf(ReportCode code) {
    switch (code) {
        case ReportCode::DuplicateSeed: return ProblemKind::DuplicateSeed;
        case ReportCode::SeedWithoutCell: return ProblemKind::SeedWithoutCell;
        case ReportCode::LostOverride: return ProblemKind::LostOverride;
        case ReportCode::LostPiece: return ProblemKind::LostPiece;
        case ReportCode::LooseCut: return ProblemKind::LooseCut;
        case ReportCode::NoRoom: return ProblemKind::NoRoom;
        case ReportCode::Gap: return ProblemKind::Gap;
        case ReportCode::ThinPiece: return ProblemKind::ThinPiece;
        case ReportCode::VanishedPiece: return ProblemKind::VanishedPiece;
        case ReportCode::SplitCell: break;
        case ReportCode::MergedPiece:
        case ReportCode::DroppedSeed: break;  // it was asked for
    }
    return std::nullopt;
}

std::string rounded(double value) { return roundedText(value, kDigits); }

/// Finds what is to be looked at in one bake.
class BakeProblems {
public:
    BakeProblems(const Asset& asset, const Bake& bake, const ProblemLimits& limits)
        : m_asset(asset), m_bake(bake), m_limits(limits), m_hasGap(gapOf(recipeOf(asset)) > 0.0) {}

    std::vector<Problem> found(int threads) {
        for (const Report& report : m_bake.reports) add(report);
        const std::vector<SeedId> seeds = rootSeeds();
        for (const BakedBreaking& breaking : m_bake.breakings) addPieces(breaking, seeds, threads);
        std::ranges::stable_sort(m_problems, {}, &Problem::kind);
        return std::move(m_problems);
    }

private:
    static constexpr std::size_t kBlock = 128;  // pieces that a thread looks at at a time

    /// Of deeper levels a report begins with the name of what was broken; then it is about that.
    void add(const Report& report) {
        const std::optional<ProblemKind> kind = kindOf(report.code);
        const bool isAskedFor = report.code == ReportCode::Gap && m_hasGap;
        if (!kind || isAskedFor) return;
        Problem problem{.kind = *kind, .asset = m_asset.id, .value = report.amount, .message = report.message};
        if (*kind == ProblemKind::NoRoom) problem.layer = report.of;
        if (const BakedBreaking* breaking = deeperBreakingOf(report)) {
            problem.level = breaking->level;
            problem.fragment = breaking->parent;
            problem.path = pathOfId(m_bake.fragmentId(breaking->parent));
            problem.where = Vec2{m_bake.fragment(breaking->parent).solid.offset()};
        } else if (report.code == ReportCode::LostOverride || report.code == ReportCode::LooseCut) {
            problem.seed = SeedId{report.of, report.seed};
        } else if (const Seeds& seeds = m_bake.breakings.front().seeds; report.seed < seeds.ids.size()) {
            problem.seed = seeds.ids[report.seed];
            problem.where = seeds.positions[report.seed];
        }
        m_problems.push_back(std::move(problem));
    }

    const BakedBreaking* deeperBreakingOf(const Report& report) const {
        if (!report.message.starts_with("Fragment ")) return nullptr;
        for (const BakedBreaking& breaking : m_bake.breakings) {
            if (breaking.parent == kNone) continue;
            if (report.message.starts_with("Fragment " + m_bake.fragmentId(breaking.parent) + ": ")) return &breaking;
        }
        return nullptr;
    }

    /// By what of the asset's own pattern each fragment is chosen.
    std::vector<SeedId> rootSeeds() const {
        std::vector<SeedId> seeds;
        for (const BakedBreaking& breaking : m_bake.breakings) {
            for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
                const Fragment fragment = breaking.fragments[k];
                seeds.push_back(breaking.parent != kNone
                                    ? seeds[breaking.parent]
                                    : cellId(fragment.all().partition, fragment.piece(), breaking.seeds.ids));
            }
        }
        return seeds;
    }

    void addPieces(const BakedBreaking& breaking, const std::vector<SeedId>& seeds, int threads) {
        const std::uint32_t count = breaking.fragments.count();
        double volume = 0.0;
        for (std::uint32_t k = 0; k < count; ++k) volume += breaking.fragments[k].volume();
        const double least = m_limits.meanShare * volume / count;
        std::vector<std::vector<Problem>> parts((count + kBlock - 1) / kBlock);
        forEachIndex(parts.size(), threads, [&](std::size_t part) {
            const IndexRange range = partOf(count, part, parts.size());
            for (std::size_t k = range.begin; k < range.end; ++k) {
                const auto piece = static_cast<std::uint32_t>(k);
                addPiece(breaking, piece, seeds[breaking.first + piece], least, parts[part]);
            }
        });
        for (std::vector<Problem>& part : parts) std::ranges::move(part, std::back_inserter(m_problems));
    }

    void addPiece(const BakedBreaking& breaking, std::uint32_t piece, SeedId seed, double leastVolume,
                  std::vector<Problem>& problems) const {
        const Fragment solid = breaking.fragments[piece];
        const auto add = [&](ProblemKind kind, double value, double limit, const std::string& text) {
            const std::uint32_t fragment = breaking.first + piece;
            const std::string id = m_bake.fragmentId(fragment);
            problems.push_back({.kind = kind,
                                .asset = m_asset.id,
                                .seed = seed == SeedId{} ? std::nullopt : std::optional(seed),
                                .level = breaking.level,
                                .fragment = fragment,
                                .path = pathOfId(id),
                                .where = Vec2{solid.offset()},
                                .value = value,
                                .limit = limit,
                                .message = "Fragment " + id + " " + text});
        };
        const double aspect = aspectOf(solid.outline());
        if (aspect > m_limits.aspect) {
            add(ProblemKind::Sliver, aspect, m_limits.aspect,
                "is " + rounded(aspect) + " times as long as wide, a sliver; up to " + rounded(m_limits.aspect) +
                    " is usual.");
        }
        if (solid.volume() < leastVolume) {
            add(ProblemKind::TinyPiece, solid.volume(), leastVolume,
                "has " + rounded(solid.volume()) + " m^3, less than " + rounded(100.0 * m_limits.meanShare) +
                    " % of the mean of the pieces it was made with, " + rounded(leastVolume / m_limits.meanShare) +
                    " m^3.");
        }
        if (solid.isConvex()) return;
        if (const std::size_t hulls = solid.hulls().size(); hulls > m_limits.hulls) {
            add(ProblemKind::ManyHulls, static_cast<double>(hulls), m_limits.hulls,
                "needs " + std::to_string(hulls) + " convex hulls to collide; more than " +
                    std::to_string(m_limits.hulls) + " slow a simulation down.");
        }
    }

    const Asset& m_asset;
    const Bake& m_bake;
    const ProblemLimits& m_limits;
    const bool m_hasGap;  // that was asked for
    std::vector<Problem> m_problems;
};

Problem outlineProblem(const Asset& asset, const PolygonFault& fault) {
    return {.kind = ProblemKind::FaultyOutline, .asset = asset.id, .where = fault.where, .message = fault.message};
}

}  // namespace

const char* nameOf(ProblemKind kind) {
    static constexpr std::array kNames = {"FaultyOutline", "DuplicateSeed",  "SeedWithoutCell", "LostOverride",
                                          "LostPiece",     "LooseCut",       "NoRoom",          "Gap",
                                          "ThinPiece",     "VanishedPiece",  "Sliver",          "TinyPiece",
                                          "ManyHulls",     "UnknownStrength"};
    static_assert(kNames.size() == kProblemKinds);
    return kNames[static_cast<std::size_t>(kind)];
}

double Problem::badness() const {
    if (kind == ProblemKind::FaultyOutline) return std::numeric_limits<double>::infinity();
    if (kind == ProblemKind::TinyPiece) return value > 0.0 ? limit / value : std::numeric_limits<double>::infinity();
    return limit > 0.0 ? std::max(value / limit, 1.0) : 1.0;
}

std::vector<Problem> outlineProblems(const Asset& asset) {
    std::vector<Problem> problems;
    for (const PolygonFault& fault : polygonFaults(asset.prism.outline)) {
        problems.push_back(outlineProblem(asset, fault));
    }
    if (!problems.empty()) return problems;
    if (const std::optional<PolygonFault> fault = narrowFault(asset.prism.outline)) {
        problems.push_back(outlineProblem(asset, *fault));
    }
    return problems;
}

std::vector<Problem> strengthProblems(const Asset& asset, const Material& material) {
    if (!lacksStrength(asset, material)) return {};
    return {{.kind = ProblemKind::UnknownStrength,
             .asset = asset.id,
             .value = asset.threshold,
             .message = "The threshold is to follow from strength, but the material \"" + material.name +
                        "\" tells none: the typed one, " + rounded(asset.threshold) + " N s, is in force."}};
}

std::vector<Problem> problemsOf(const Asset& asset, const Bake& bake, const ProblemLimits& limits,
                                const TaskContext& task) {
    return BakeProblems(asset, bake, limits).found(task.threads);
}

std::vector<Problem> problemsOf(const Project& project, const AssetBakes& bakes, const ProblemLimits& limits,
                                const TaskContext& task) {
    std::vector<Problem> problems;
    for (const Asset& asset : project.assets) {
        const auto baked = bakes.find({asset.id});
        const bool isBaked = baked != bakes.end() && baked->second;
        std::ranges::move(isBaked ? problemsOf(asset, *baked->second, limits, task) : outlineProblems(asset),
                          std::back_inserter(problems));
        if (const Material* material = findMaterial(project, asset.material)) {
            std::ranges::move(strengthProblems(asset, *material), std::back_inserter(problems));
        }
    }
    return problems;
}

std::vector<bool> fragmentsWithProblems(const Bake& bake, std::span<const Problem> problems) {
    std::vector<bool> isIn(bake.fragmentCount(), false);
    for (const Problem& problem : problems) {
        if (problem.asset == bake.asset && problem.fragment < isIn.size()) isIn[problem.fragment] = true;
    }
    return isIn;
}

}  // namespace rubble
