#pragma once

#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/search/BoxTree.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Finds for many points whether they are in a closed mesh, by the parity of the triangles above: exactly, whatever the
/// ray upwards meets. O(log n) for most.
class MeshContainment {
public:
    /// The mesh must outlive this, and have exactly usable coordinates.
    explicit MeshContainment(const TriangleMesh& mesh);

    Containment containment(Vec3 point) const;
    /// The boxes of the mesh's triangles.
    const BoxTree& triangleBoxes() const { return m_tree; }
    bool isInside(Vec3 point) const { return containment(point) == Containment::Inside; }

private:
    enum class Passage { Beside, Through, Touching };
    Passage passageAbove(std::uint32_t triangle, Vec3 point) const;

    const TriangleMesh& m_mesh;
    double m_top = 0.0;  // m: the largest z
    BoxTree m_tree;      // of the triangles
};

}  // namespace rubble
