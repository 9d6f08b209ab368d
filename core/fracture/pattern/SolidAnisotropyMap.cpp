#include "core/fracture/pattern/SolidAnisotropyMap.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/pattern/Pattern.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace rubble {
namespace {

/// The direction of a grain, in space.
Vec3 directionOf(const Grain& grain) {
    return {cosine(grain.tilt) * Vec2(cosine(grain.angle), sine(grain.angle)), sine(grain.tilt)};
}

}  // namespace

std::optional<SolidAnisotropyMap> SolidAnisotropyMap::of(const Pattern& pattern, const Box3& bounds) {
    std::optional<SolidAnisotropyMap> all;
    for (const PatternLayer& layer : pattern.layers) {
        const auto* grain = std::get_if<Grain>(&layer.parameters);
        if (!grain || !layer.isOn || grain->ratio == 1.0) continue;
        if (!all) all.emplace().m_origin = bounds.centre();
        const Vec3 along = directionOf(*grain);
        const Mat3 projection = glm::outerProduct(along, along);
        all->m_forward = (Mat3(1.0) + (1.0 / grain->ratio - 1.0) * projection) * all->m_forward;
        all->m_inverse = all->m_inverse * (Mat3(1.0) + (grain->ratio - 1.0) * projection);
    }
    return all;
}

SolidPartition SolidAnisotropyMap::inverse(SolidPartition partition, const TriangleMesh& mesh, Vec3 origin) const {
    for (std::size_t k = 0; k < partition.points.size(); ++k) {
        const bool isCorner = k < mesh.points.size();
        const Vec3 point = isCorner ? mesh.points[k] : inverse(partition.origin + partition.points[k]);
        partition.points[k] = point - origin;
    }
    for (double& volume : partition.volumes) volume *= glm::determinant(m_inverse);
    partition.origin = origin;
    return partition;
}

}  // namespace rubble
