#pragma once

#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <optional>

namespace rubble {

struct Pattern;

/// What AnisotropyMap is in the plane: the affine map from a mesh's space to one in which distances are isotropic, and
/// back. Relative to the middle of the mesh's box.
class SolidAnisotropyMap {
public:
    /// The composition of the pattern's enabled grain layers; nothing if there are none.
    static std::optional<SolidAnisotropyMap> of(const Pattern& pattern, const Box3& bounds);

    Vec3 operator()(Vec3 point) const { return m_forward * (point - m_origin); }
    /// The inverse map of a point.
    Vec3 inverse(Vec3 mapped) const { return m_origin + m_inverse * mapped; }
    /// Maps a partition of the mapped mesh back to the mesh, whose corners are restored bit for bit, with points
    /// relative to `origin`. The fragments of a seed keep their order.
    SolidPartition inverse(SolidPartition partition, const TriangleMesh& mesh, Vec3 origin) const;

private:
    Vec3 m_origin{0.0};
    Mat3 m_forward{1.0};
    Mat3 m_inverse{1.0};
};

}  // namespace rubble
