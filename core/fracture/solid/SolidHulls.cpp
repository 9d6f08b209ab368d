#include "core/fracture/solid/SolidHulls.h"

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/fracture/solid/SampledHulls.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace rubble {
namespace {

using SplitsOfEach = std::vector<Result<ConcaveSplits>>;

/// Which of the splits of several solids are made: the first of each, as many as HullLimits ask for. Splits are only
/// tried where they could save more than those that are known; which are made does not depend on that.
class SplitChoice {
public:
    SplitChoice(SplitsOfEach& splits, const HullLimits& limits, const TaskContext& task)
        : m_splits(splits), m_limits(limits), m_task(task), m_made(splits.size(), 0) {}

    /// The number of splits that are made of each solid; unfinished when the task is cancelled.
    std::vector<std::size_t> make() && {
        boundEach();
        double volume = 0.0, excess = 0.0;
        for (std::size_t solid = 0; solid < m_splits.size(); ++solid) {
            if (!m_splits[solid]) continue;
            volume += m_splits[solid]->volume();
            excess += m_splits[solid]->excessAfter(m_made[solid]);
            offer(solid);
        }
        while (excess > (m_limits.sumRatio - 1.0) * volume && !m_offers.empty() && !m_task.isCancelled()) {
            if (!m_offers.top().isKnown) {
                tryMore();
                continue;
            }
            const Offer best = m_offers.top();
            m_offers.pop();
            const ConcaveSplits& splits = *m_splits[best.solid];
            excess += splits.excessAfter(best.made) - splits.excessAfter(m_made[best.solid]);
            m_made[best.solid] = best.made;
            offer(best.solid);
        }
        return std::move(m_made);
    }

private:
    /// What more splits of a solid would save.
    struct Offer {
        double saved = 0.0;  // m³, for each part more; at most, where it is not known
        std::size_t solid = 0;
        std::size_t made = 0;  // the number of splits then
        bool isKnown = false;
        bool operator<(const Offer& other) const {
            return saved != other.saved ? saved < other.saved : solid > other.solid;
        }
    };

    /// Splits each solid until its hulls exceed it by no more than the worst may. In parallel.
    void boundEach() {
        forEachIndex(m_splits.size(), m_task.threads, [&](std::size_t solid) {
            const auto exceeds = [&] {
                return m_splits[solid]->excessAfter(m_made[solid]) >
                       (m_limits.worstRatio - 1.0) * m_splits[solid]->volume();
            };
            while (m_splits[solid] && exceeds() && !m_splits[solid]->isFinished()) {
                trySplit(solid);
                if (m_splits[solid]) m_made[solid] = m_splits[solid]->splitCount();
            }
        });
    }

    void trySplit(std::size_t solid) {
        if (const Status split = m_splits[solid]->splitOnce(m_task); !split) m_splits[solid] = split.error();
    }

    /// Tries one more split of the solids whose splits could save most. In parallel, as many on any threads.
    void tryMore() {
        constexpr std::size_t kAtOnce = 16;
        std::vector<std::size_t> solids;
        for (; !m_offers.empty() && !m_offers.top().isKnown && solids.size() < kAtOnce; m_offers.pop())
            solids.push_back(m_offers.top().solid);
        forEachIndex(solids.size(), m_task.threads, [&](std::size_t k) { trySplit(solids[k]); });
        for (const std::size_t solid : solids) {
            if (m_splits[solid]) offer(solid);
        }
    }

    /// Adds the best offer of a solid, if there is one that saves something: of its known splits, or what those not yet
    /// tried could save if the parts then had no excess.
    void offer(std::size_t solid) {
        const ConcaveSplits& splits = *m_splits[solid];
        const std::size_t made = m_made[solid];
        const double excess = splits.excessAfter(made);
        const std::size_t parts = splits.partsAfter(made);
        Offer best{.solid = solid, .isKnown = true};
        for (std::size_t more = made + 1; more <= splits.splitCount(); ++more) {
            const double saved =
                (excess - splits.excessAfter(more)) / static_cast<double>(splits.partsAfter(more) - parts);
            if (saved > best.saved) best = {saved, solid, more, true};
        }
        if (!splits.isFinished()) {
            const double most = excess / static_cast<double>(splits.partsAfter(splits.splitCount()) + 1 - parts);
            if (most > best.saved) best = {.saved = most, .solid = solid};
        }
        if (best.saved > 0.0) m_offers.push(best);
    }

    SplitsOfEach& m_splits;
    HullLimits m_limits;
    const TaskContext& m_task;
    std::vector<std::size_t> m_made;
    std::priority_queue<Offer> m_offers;  // one of each solid at most
};

Result<std::vector<Polytope>> simplifiedHulls(const ConcaveSplits& splits, std::size_t made) {
    Result<std::vector<Polytope>> hulls = splits.hullsAfter(made);
    if (!hulls) return hulls.error();
    for (Polytope& hull : *hulls) hull = simplifiedHull(hull, collisionDetail(hull));
    return hulls;
}

}  // namespace

TriangleMesh meshOf(const SolidPartition& partition, std::uint32_t fragment) {
    TriangleMesh mesh;
    std::vector<std::uint32_t> used;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        for (std::array<std::uint32_t, 3> triangle : partition.trianglesOf(side.face)) {
            if (side.isReversed) std::swap(triangle[1], triangle[2]);
            mesh.triangles.push_back(triangle);
            used.insert(used.end(), triangle.begin(), triangle.end());
        }
    }
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
        for (std::uint32_t& point : triangle) {
            point = static_cast<std::uint32_t>(std::ranges::lower_bound(used, point) - used.begin());
        }
    }
    for (const std::uint32_t point : used) mesh.points.push_back(partition.points[point]);
    return mesh;
}

Result<std::vector<Polytope>> hullsOf(const TriangleMesh& mesh, const HullLimits& limits) {
    return std::move(hullsOfEach(1, [&](std::uint32_t) { return mesh; }, limits, {})[0]);
}

std::vector<Result<std::vector<Polytope>>> hullsOfEach(std::size_t count,
                                                       const std::function<TriangleMesh(std::uint32_t)>& meshOf,
                                                       const HullLimits& limits, const TaskContext& task) {
    SplitsOfEach splits(count, Result<ConcaveSplits>(ConcaveSplits{}));
    forEachIndex(count, task.threads, [&](std::size_t k) {
        if (!task.isCancelled()) splits[k] = ConcaveSplits::of(meshOf(static_cast<std::uint32_t>(k)), limits.splits);
    });
    std::vector<Result<std::vector<Polytope>>> hulls(count, Result<std::vector<Polytope>>(std::vector<Polytope>{}));
    if (task.isCancelled()) return hulls;
    const std::vector<std::size_t> made = SplitChoice(splits, limits, task).make();
    if (task.isCancelled()) return hulls;
    forEachIndex(count, task.threads, [&](std::size_t k) {
        if (!splits[k]) {
            hulls[k] = splits[k].error();
        } else if (!task.isCancelled()) {
            hulls[k] = simplifiedHulls(*splits[k], made[k]);
        }
    });
    return hulls;
}

Result<std::vector<std::vector<Polytope>>> fragmentHulls(const SolidPartition& partition, const HullLimits& limits,
                                                         const TaskContext& task) {
    std::vector<Result<std::vector<Polytope>>> each = hullsOfEach(
        partition.fragmentCount(), [&](std::uint32_t fragment) { return meshOf(partition, fragment); }, limits, task);
    if (task.isCancelled()) return TaskContext::cancelled();
    std::vector<std::vector<Polytope>> hulls;
    for (std::size_t fragment = 0; fragment < each.size(); ++fragment) {
        if (!each[fragment]) {
            return Error{each[fragment].error().code,
                         "Fragment " + std::to_string(fragment) + " has no hull: " + each[fragment].error().message};
        }
        hulls.push_back(std::move(*each[fragment]));
    }
    return hulls;
}

Result<std::vector<Polytope>> coarseHulls(const TriangleMesh& mesh, int cells, const TaskContext& task) {
    constexpr int kRelaxations = 4;
    constexpr std::size_t kMaxExact = 30'000;  // triangles that are cut again for each relaxation
    if (mesh.triangles.size() > kMaxExact) return sampledHulls(mesh, cells, task);
    const Box3 box = boundsOf(mesh);
    Random random(mixSeeds(static_cast<std::uint64_t>(cells), mesh.triangles.size()));
    std::vector<Vec3> seeds;
    for (int k = 0; k < cells; ++k) {
        const double x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
        seeds.push_back({x, y, random.between(box.min.z, box.max.z)});
    }
    for (int round = 0;; ++round) {
        const Result<SolidPartition> partition = cutSolid(mesh, seeds, task);
        if (!partition) return partition.error();
        if (round == kRelaxations) {
            const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition, {}, task);
            if (!hulls) return hulls.error();
            std::vector<Polytope> all;
            for (const std::vector<Polytope>& some : *hulls) {
                for (const Polytope& hull : some) all.push_back(translated(hull, partition->origin));
            }
            return all;
        }
        seeds.clear();
        for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
            const TriangleMesh part = meshOf(*partition, k);
            seeds.push_back(partition->origin + massOf(part.points, part.triangles).centre);
        }
    }
}

}  // namespace rubble
