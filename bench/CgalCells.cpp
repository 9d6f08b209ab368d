#include "bench/Peers.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace rubble::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // its seed
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Vec2, Kernel>;               // its Voronoi corner
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

Vec2 toVec2(const Kernel::Point_2& point) { return {point.x(), point.y()}; }

Triangulation triangulated(std::span<const Vec2> seeds) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    points.reserve(seeds.size());
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        points.push_back({{seeds[seed].x, seeds[seed].y}, seed});
    }
    Triangulation triangulation(points.begin(), points.end());
    for (const auto face : triangulation.finite_face_handles()) {
        face->info() = toVec2(triangulation.circumcenter(face));
    }
    return triangulation;
}

void addUnboundedCell(const Triangulation& triangulation, Triangulation::Vertex_handle vertex,
                      std::vector<Vec2>& neighbours, CellWriter& writer) {
    neighbours.clear();
    auto neighbour = triangulation.incident_vertices(vertex);
    const auto first = neighbour;
    do {
        if (!triangulation.is_infinite(neighbour)) neighbours.push_back(toVec2(neighbour->point()));
    } while (++neighbour != first);
    writer.endUnbounded(vertex->info(), toVec2(vertex->point()), neighbours);
}

}  // namespace

Cells cellsByCgal(std::span<const Vec2> seeds) {
    const Triangulation triangulation = triangulated(seeds);
    CellWriter writer(seeds.size());
    std::vector<Vec2> neighbours;
    for (const auto vertex : triangulation.finite_vertex_handles()) {
        auto face = triangulation.incident_faces(vertex);
        const auto first = face;
        bool isUnbounded = false;
        do {
            isUnbounded = isUnbounded || triangulation.is_infinite(face);
            writer.addCorner(face->info());
        } while (++face != first);
        if (isUnbounded) {
            addUnboundedCell(triangulation, vertex, neighbours, writer);
        } else {
            writer.endBounded(vertex->info());
        }
    }
    return writer.take();
}

std::size_t dualByCgal(std::span<const Vec2> seeds) { return triangulated(seeds).number_of_faces(); }

}  // namespace rubble::bench
