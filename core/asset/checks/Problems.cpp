#include "core/asset/checks/Problems.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/fracture/fragments/FragmentName.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/geometry/polygon/PolygonFaults.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <limits>

namespace rubble {
namespace {

constexpr int kDigits = 3;  // of figures in sentences

std::string rounded(double value) { return roundedText(value, kDigits); }

/// Finds the problems of one bake.
class BakeProblems {
public:
    BakeProblems(const Asset& asset, const Bake& bake, const ProblemLimits& limits)
        : m_asset(asset),
          m_bake(bake),
          m_limits(limits),
          m_hasGap(gapOf(recipeOf(asset)) > 0.0),
          m_problems(limits.most) {}

    std::vector<Diagnostic> found(int threads) {
        for (const Diagnostic& one : m_bake.diagnostics) add(one);
        addLostOfBonding();
        const std::vector<SeedId> seeds = rootSeeds();
        for (const BakedFracture& fracture : m_bake.fractures) addPieces(fracture, seeds, threads);
        std::vector<Diagnostic> problems = std::move(m_problems).list({.asset = m_asset.id});
        std::ranges::stable_sort(problems, {}, &Diagnostic::code);
        return problems;
    }
    /// The number of diagnostics and fragments visited by found().
    std::size_t visited() const { return m_visited; }

private:
    static constexpr std::size_t kBlock = 128;         // pieces per task
    static constexpr std::size_t kBlocksAtOnce = 256;  // after which problems that would be too many are only counted

    /// The problems of some pieces: those of a code that has no room left are only counted.
    struct Part {
        std::vector<Diagnostic> made;
        std::array<std::size_t, kDiagnosticCodes> unmade{};
    };

    Fragment fragmentOf(const BakedFracture& fracture, std::uint32_t k) const {
        ++m_visited;
        return fracture.fragments[k];
    }

    void add(const Diagnostic& one) {
        ++m_visited;
        const bool isGap = one.code == DiagnosticCode::Gap && !m_hasGap;
        if (one.severity == Severity::Note && !isGap) return;
        Diagnostic problem = one;
        if (problem.place.level > 0) problem.place.index = kNone;
        m_problems.add(std::move(problem));
    }

    /// Paths of fragments that never break or are in a cluster, but do not exist.
    void addLostOfBonding() {
        const Bonding& bonding = m_asset.bonding;
        if (m_asset.breakAs != BreakAs::Bonded || (bonding.neverBreaks.empty() && bonding.clusters.empty())) return;
        std::vector<FragmentPath> paths;
        paths.reserve(m_bake.fragmentCount());
        for (std::uint32_t k = 0; k < m_bake.fragmentCount(); ++k) paths.push_back(m_bake.fragmentPath(k));
        std::ranges::sort(paths);
        const auto addIfLost = [&](const FragmentPath& path, const std::string& what) {
            if (std::ranges::binary_search(paths, path)) return;
            m_problems.add(diagnostic(
                DiagnosticCode::LostPiece, {.asset = m_asset.id, .path = path},
                "Fragment " + path + " of asset " + quotedName(m_asset.name) + what + ", but does not exist."));
        };
        for (const FragmentPath& path : bonding.neverBreaks) addIfLost(path, " is set to never break");
        for (const FragmentCluster& cluster : bonding.clusters) {
            for (const FragmentPath& path : cluster.fragments)
                addIfLost(path, " is in a cluster of level " + std::to_string(cluster.level));
        }
    }

    /// The seed of the asset's own pattern that each fragment comes from.
    std::vector<SeedId> rootSeeds() const {
        std::vector<SeedId> seeds;
        for (const BakedFracture& fracture : m_bake.fractures) {
            for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
                const Fragment fragment = fragmentOf(fracture, k);
                seeds.push_back(fracture.parent != kNone ? seeds[fracture.parent]
                                                         : cellId(fragment, fracture.seeds.ids));
            }
        }
        return seeds;
    }

    void addPieces(const BakedFracture& fracture, const std::vector<SeedId>& seeds, int threads) {
        const std::uint32_t count = fracture.fragments.count();
        double volume = 0.0;
        for (std::uint32_t k = 0; k < count; ++k) volume += fragmentOf(fracture, k).volume();
        const double least = m_limits.meanShare * volume / count;
        const std::size_t blocks = (count + kBlock - 1) / kBlock;
        for (std::size_t first = 0; first < blocks; first += kBlocksAtOnce) {
            std::vector<Part> parts(std::min(kBlocksAtOnce, blocks - first));
            forEachIndex(parts.size(), threads, [&](std::size_t part) {
                const IndexRange range = chunkRange(count, first + part, blocks);
                for (std::size_t k = range.begin; k < range.end; ++k) {
                    const auto piece = static_cast<std::uint32_t>(k);
                    addPiece(fracture, piece, seeds[fracture.first + piece], least, parts[part]);
                }
            });
            for (Part& part : parts) {
                for (Diagnostic& one : part.made) m_problems.add(std::move(one));
                for (std::size_t code = 0; code < part.unmade.size(); ++code)
                    m_problems.addUnmade(static_cast<DiagnosticCode>(code), part.unmade[code]);
            }
        }
    }

    void addPiece(const BakedFracture& fracture, std::uint32_t piece, SeedId seed, double leastVolume,
                  Part& problems) const {
        const Fragment solid = fragmentOf(fracture, piece);
        const auto add = [&](DiagnosticCode code, double value, double limit, const std::string& text) {
            if (!m_problems.hasRoom(code)) {
                ++problems.unmade[static_cast<std::size_t>(code)];
                return;
            }
            const std::uint32_t fragment = fracture.first + piece;
            const std::string id = m_bake.fragmentId(fragment);
            const Vec2 offset{solid.offset()};
            DiagnosticPlace place{.asset = m_asset.id,
                                  .level = fracture.level,
                                  .fragment = fragment,
                                  .path = pathOfId(id),
                                  .point = DiagnosticPlace::Point{offset.x, offset.y}};
            if (seed != SeedId{}) {
                place.layer = seed.layer;
                place.index = seed.index;
            }
            problems.made.push_back(diagnostic(code, std::move(place), "Fragment " + id + " " + text, value, limit));
        };
        const double aspect = solid.aspectRatio();
        if (aspect > m_limits.aspect) {
            add(DiagnosticCode::Sliver, aspect, m_limits.aspect,
                "is " + rounded(aspect) + " times as long as wide, a sliver; up to " + rounded(m_limits.aspect) +
                    " is normal.");
        }
        if (solid.volume() < leastVolume) {
            add(DiagnosticCode::TinyPiece, solid.volume(), leastVolume,
                "has " + quantityText(QuantityKind::Volume, solid.volume()) + ", less than " +
                    rounded(100.0 * m_limits.meanShare) + " % of the mean of its siblings, " +
                    quantityText(QuantityKind::Volume, leastVolume / m_limits.meanShare) + ".");
        }
        if (solid.isConvex()) return;
        if (const std::size_t hulls = solid.hulls().size(); hulls > m_limits.hulls) {
            add(DiagnosticCode::ManyHulls, static_cast<double>(hulls), m_limits.hulls,
                "needs " + std::to_string(hulls) + " convex hulls to collide; more than " +
                    std::to_string(m_limits.hulls) + " slow a simulation down.");
        }
    }

    const Asset& m_asset;
    const Bake& m_bake;
    const ProblemLimits& m_limits;
    const bool m_hasGap;  // that was asked for
    CappedDiagnostics m_problems;
    mutable std::atomic<std::size_t> m_visited = 0;  // by all threads
};

Diagnostic outlineProblem(const Asset& asset, const PolygonFault& fault) {
    return diagnostic(DiagnosticCode::FaultyOutline,
                      {.asset = asset.id, .point = DiagnosticPlace::Point{fault.where.x, fault.where.y}},
                      fault.message);
}

}  // namespace

double badness(const Diagnostic& problem) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (problem.code == DiagnosticCode::FaultyOutline) return kInfinity;
    if (problem.code == DiagnosticCode::TinyPiece)
        return problem.value > 0.0 ? problem.limit / problem.value : kInfinity;
    return problem.limit > 0.0 ? std::max(problem.value / problem.limit, 1.0) : 1.0;
}

std::vector<Diagnostic> outlineProblems(const Asset& asset) {
    std::vector<Diagnostic> problems;
    if (!asset.isPrism()) return problems;
    for (const PolygonFault& fault : polygonFaults(asset.prism().outline)) {
        problems.push_back(outlineProblem(asset, fault));
    }
    if (!problems.empty()) return problems;
    if (const std::optional<PolygonFault> fault = narrowFault(asset.prism().outline)) {
        problems.push_back(outlineProblem(asset, *fault));
    }
    return problems;
}

std::vector<Diagnostic> strengthProblems(const Asset& asset, const Material& material) {
    if (!lacksStrength(asset, material)) return {};
    return {diagnostic(DiagnosticCode::UnknownStrength, {.asset = asset.id},
                       "The threshold is to be derived from strength, but the material " + quotedName(material.name) +
                           " has none: the stored one, " + quantityText(QuantityKind::Impulse, asset.threshold) +
                           ", is used.",
                       asset.threshold)};
}

std::vector<Diagnostic> problemsOf(const Asset& asset, const Bake& bake, const ProblemLimits& limits,
                                   const TaskContext& task, std::size_t* visited) {
    BakeProblems problems(asset, bake, limits);
    std::vector<Diagnostic> found = problems.found(task.threads);
    if (visited) *visited += problems.visited();
    return found;
}

std::vector<Diagnostic> problemsOf(const Project& project, const AssetBakes& bakes, const ProblemLimits& limits,
                                   const TaskContext& task) {
    std::vector<Diagnostic> problems;
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

std::vector<bool> fragmentsWithProblems(const Bake& bake, std::span<const Diagnostic> problems) {
    std::vector<bool> isIn(bake.fragmentCount(), false);
    for (const Diagnostic& problem : problems) {
        if (problem.place.asset == bake.asset && problem.place.fragment < isIn.size())
            isIn[problem.place.fragment] = true;
    }
    return isIn;
}

}  // namespace rubble
