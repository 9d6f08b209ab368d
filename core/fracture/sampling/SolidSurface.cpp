#include "core/fracture/sampling/SolidSurface.h"

#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rubble {
SolidSurface::Content::Content(TriangleMesh given) : mesh(std::move(given)), bounds(boundsOf(mesh)), containment(mesh) {
    volume = signedVolume(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += glm::length(doubleArea(mesh, t)) / 2.0;
}

Result<SolidSurface> SolidSurface::of(TriangleMesh mesh) {
    if (mesh.triangles.empty()) return Error{ErrorCode::BadInput, "The mesh has no triangles."};
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
        const Vec3 size = glm::abs(mesh.points[k]);  // comparisons are false for what is not a number
        if (size.x < kMaxMeshCoordinate && size.y < kMaxMeshCoordinate && size.z < kMaxMeshCoordinate) continue;
        return Error{ErrorCode::BadInput, "Point " + std::to_string(k) + " of the mesh is not finite or too far out."};
    }
    SolidSurface surface(std::make_shared<const Content>(std::move(mesh)));
    if (!(surface.volume() > 0.0))
        return Error{ErrorCode::Degenerate, "The mesh encloses no volume: turn its triangles outward."};
    return surface;
}

bool SolidSurface::contains(Vec3 point) const {
    return m_content->containment.containment(point) != Containment::Outside;
}

double SolidSurface::depth(Vec3 point) const {
    double nearest = HUGE_VAL;
    m_content->containment.triangleBoxes().visitNear(point, [&](std::uint32_t triangle) {
        const auto& [a, b, c] = mesh().triangles[triangle];
        nearest = std::min(nearest, distanceToTriangle(point, mesh().points[a], mesh().points[b], mesh().points[c]));
        return nearest;
    });
    return contains(point) ? nearest : -nearest;
}

}  // namespace rubble
