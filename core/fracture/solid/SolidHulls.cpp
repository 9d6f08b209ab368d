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

/// Which of the splits of several solids are made: the first of each, as many as HullLimits ask for.
class SplitChoice {
public:
    SplitChoice(const SplitsOfEach& splits, const HullLimits& limits)
        : m_splits(splits), m_limits(limits), m_made(splits.size(), 0) {}

    /// The number of splits that are made of each solid.
    std::vector<std::size_t> make() && {
        double volume = 0.0, excess = 0.0;
        for (std::size_t solid = 0; solid < m_splits.size(); ++solid) {
            if (!m_splits[solid]) continue;
            const ConcaveSplits& splits = *m_splits[solid];
            const double most = (m_limits.worstRatio - 1.0) * splits.volume();
            while (m_made[solid] < splits.splitCount() && splits.excessAfter(m_made[solid]) > most) ++m_made[solid];
            volume += splits.volume();
            excess += splits.excessAfter(m_made[solid]);
            offer(solid);
        }
        while (excess > (m_limits.sumRatio - 1.0) * volume && !m_offers.empty()) {
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
        double saved = 0.0;  // m³, for each part more
        std::size_t solid = 0;
        std::size_t made = 0;  // the number of splits then
        bool operator<(const Offer& other) const {
            return saved != other.saved ? saved < other.saved : solid > other.solid;
        }
    };

    /// Adds the best offer of a solid, if there is one that saves something.
    void offer(std::size_t solid) {
        const ConcaveSplits& splits = *m_splits[solid];
        const std::size_t made = m_made[solid];
        Offer best{.solid = solid};
        for (std::size_t more = made + 1; more <= splits.splitCount(); ++more) {
            const double saved = (splits.excessAfter(made) - splits.excessAfter(more)) /
                                 static_cast<double>(splits.partsAfter(more) - splits.partsAfter(made));
            if (saved > best.saved) best = {saved, solid, more};
        }
        if (best.saved > 0.0) m_offers.push(best);
    }

    const SplitsOfEach& m_splits;
    HullLimits m_limits;
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
    const std::vector<std::size_t> made = SplitChoice(splits, limits).make();
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
