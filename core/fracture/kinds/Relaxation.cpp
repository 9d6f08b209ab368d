#include "core/fracture/kinds/Relaxation.h"

#include "core/base/Parallel.h"
#include "core/fracture/layer/LayerContext.h"

#include <glm/geometric.hpp>

#include <atomic>

namespace rubble {
namespace {

/// The volume of solid in front of the faces of a fragment, seen from an origin, and its moment.
struct SolidMoment {
    double six = 0.0;  // times the volume
    Vec3 moment{0.0};  // 24 times the integral of positions
};

void addFragment(const SolidPartition& partition, std::uint32_t fragment, Vec3 origin, SolidMoment& sum) {
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        const double sign = side.isReversed ? -1.0 : 1.0;
        for (const auto& [i, j, k] : partition.trianglesOf(side.face)) {
            const Vec3 a = partition.points[i] - origin, b = partition.points[j] - origin,
                       c = partition.points[k] - origin;
            const double six = sign * glm::dot(a, glm::cross(b, c));
            sum.six += six;
            sum.moment += six * (a + b + c);
        }
    }
}

/// The centroid of all fragments of one seed, which begin at `fragment`.
Vec3 centroidOfSolidCell(const SolidPartition& partition, std::uint32_t fragment, Vec3 fallback) {
    const std::uint32_t seed = partition.seedOfFragment[fragment];
    const SolidPartition::FaceSide side = partition.facesOf(fragment)[0];
    const Vec3 origin = partition.points[partition.trianglesOf(side.face)[0][0]];  // keeps the digits of small cells
    SolidMoment sum;
    for (; fragment < partition.fragmentCount() && partition.seedOfFragment[fragment] == seed; ++fragment)
        addFragment(partition, fragment, origin, sum);
    return sum.six > 0.0 ? partition.origin + origin + sum.moment / (4.0 * sum.six) : fallback;
}

}  // namespace

Status relax(std::uint32_t rounds, const LayerContext& context, SeedSet& seeds, const CentroidOfCell& centroidOf) {
    for (std::uint32_t round = 0; round < rounds; ++round) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        const Result<Partition> cells = context.cellsOf(seeds.positions);
        if (!cells) return cells.error();
        const Partition& partition = *cells;
        std::atomic<bool> isCancelled = false;
        forEachIndex(seeds.size(), context.task.threads, [&](std::size_t seed) {
            const std::uint32_t piece = partition.pieceOfSeed[seed];
            if (piece == kNone || seeds.isLocked[seed] || isCancelled) return;
            seeds.positions[seed] = centroidOf(partition, piece, seeds.positions[seed]);
            if (context.isCancelledAt(seed)) isCancelled = true;
        });
        if (isCancelled) return TaskContext::cancelled();
    }
    return success();
}

Status relaxInSolid(std::uint32_t rounds, const SolidLayerContext& context, SeedSet& seeds) {
    std::vector<Vec3> positions(seeds.size());
    for (std::uint32_t round = 0; round < rounds && !positions.empty(); ++round) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        for (std::size_t seed = 0; seed < positions.size(); ++seed) positions[seed] = seeds.at(seed);
        const Result<SolidPartition> cells = context.cellsOf(positions);
        if (!cells) return cells.error();
        forEachIndex(seeds.size(), context.task.threads, [&](std::size_t seed) {
            const std::uint32_t fragment = cells->fragmentOfSeed[seed];
            if (fragment == kNone || seeds.isLocked[seed]) return;
            const Vec3 centroid = centroidOfSolidCell(*cells, fragment, positions[seed]);
            seeds.positions[seed] = Vec2(centroid);
            seeds.heights[seed] = centroid.z;
        });
    }
    return success();
}

}  // namespace rubble
