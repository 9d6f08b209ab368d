#include "bench/solid/SolidPeers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace rubble::bench {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

CgalMesh cgalMesh(const TriangleMesh& mesh) {
    CgalMesh result;
    for (const Vec3 point : mesh.points) result.add_vertex({point.x, point.y, point.z});
    for (const auto& [a, b, c] : mesh.triangles) {
        result.add_face(CgalMesh::Vertex_index(a), CgalMesh::Vertex_index(b), CgalMesh::Vertex_index(c));
    }
    return result;
}

}  // namespace

CutSum cutByCgal(const TriangleMesh& mesh, std::span<const ConvexCell> cells) {
    const CgalMesh whole = cgalMesh(mesh);
    CutSum sum;
    for (const ConvexCell& cell : cells) {
        std::vector<CgalPoint> corners;
        for (const Vec3 corner : cell.corners) corners.emplace_back(corner.x, corner.y, corner.z);
        CgalMesh hull, part, cut = whole;  // which is changed
        CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
        CGAL::Polygon_mesh_processing::corefine_and_compute_intersection(cut, hull, part);
        if (part.number_of_faces() == 0) continue;
        ++sum.cells;
        sum.volume += CGAL::Polygon_mesh_processing::volume(part);
    }
    return sum;
}

}  // namespace rubble::bench
