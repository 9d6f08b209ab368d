#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/MeshContainment.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <memory>

namespace rubble {

/// A closed mesh with what is asked about it for many points. Copies share it.
class SolidSurface {
public:
    /// The mesh has to be closed, counter-clockwise from outside.
    ///
    /// Errors: BadInput for no triangles, or a coordinate that is not finite or beyond kMaxMeshCoordinate; Degenerate
    /// if the volume is not above zero.
    static Result<SolidSurface> of(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return m_content->mesh; }
    const Box3& bounds() const { return m_content->bounds; }
    double volume() const { return m_content->volume; }  // m³
    double area() const { return m_content->area; }      // m², of the surface

    /// Whether a point is inside or on the surface: exactly. O(log n) for most.
    bool contains(Vec3 point) const;
    /// The distance of a point to the surface, m: negative outside. O(log n) for most.
    double depth(Vec3 point) const;

private:
    struct Content {
        explicit Content(TriangleMesh given);
        TriangleMesh mesh;
        Box3 bounds;
        double volume = 0.0;
        double area = 0.0;
        MeshContainment containment;
    };
    explicit SolidSurface(std::shared_ptr<const Content> content) : m_content(std::move(content)) {}

    std::shared_ptr<const Content> m_content;
};

}  // namespace rubble
