#include "core/fracture/pattern/SolidPatternCut.h"

#include "core/fracture/pattern/SolidAnisotropyMap.h"
#include "core/geometry/mesh/SolidLattice.h"

#include <cmath>

namespace rubble {

Result<SolidPartition> cutWithPattern(const Pattern& pattern, const TriangleMesh& mesh, std::span<const Vec3> seeds,
                                      const TaskContext& task) {
    const std::optional<SolidAnisotropyMap> grain = SolidAnisotropyMap::of(pattern, boundsOf(mesh));
    Box3 box = boundsOf(mesh);
    const bool isFinite = std::isfinite(box.diagonal());  // what is not, cutSolid() names
    if (!grain || !isFinite || mesh.triangles.empty()) return cutSolid(mesh, seeds, task);
    for (const Vec3 seed : seeds) box.include(seed);
    TriangleMesh mapped = mesh;
    for (Vec3& point : mapped.points) point = (*grain)(point);
    std::vector<Vec3> mappedSeeds(seeds.begin(), seeds.end());
    for (Vec3& seed : mappedSeeds) seed = (*grain)(seed);
    Result<SolidPartition> partition = cutSolid(mapped, mappedSeeds, task);
    if (!partition) return partition.error();
    return grain->inverse(std::move(*partition), mesh, SolidLattice(box).origin());
}

}  // namespace rubble
