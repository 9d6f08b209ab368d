#include "tests/oracle/OutlineTriangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <deque>

namespace rubble::oracle {
namespace {

constexpr std::size_t kUnknown = static_cast<std::size_t>(-2);

using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::size_t, Predicates>;
using Structure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Predicates>,
                                         CGAL::Constrained_triangulation_face_base_2<Predicates, FaceBase>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Predicates, Structure, CGAL::No_constraint_intersection_tag>;

void insertRing(Triangulation& triangulation, const Ring& ring) {
    std::vector<Triangulation::Vertex_handle> vertices;
    for (const Vec2 corner : ring) vertices.push_back(triangulation.insert(Predicates::Point_2(corner.x, corner.y)));
    for (std::size_t k = 0; k < vertices.size(); ++k)
        triangulation.insert_constraint(vertices[k], vertices[(k + 1) % vertices.size()]);
}

/// Numbers the faces inside the outline: a walk from infinity that changes sides at every ring.
std::vector<Triangulation::Face_handle> numberedInside(Triangulation& triangulation) {
    std::vector<Triangulation::Face_handle> inside;
    for (const auto face : triangulation.all_face_handles()) face->info() = kUnknown;
    std::deque<std::pair<Triangulation::Face_handle, bool>> open{{triangulation.infinite_face(), false}};
    while (!open.empty()) {
        const auto [face, isInside] = open.front();
        open.pop_front();
        if (face->info() != kUnknown) continue;
        face->info() = isInside ? inside.size() : OutlineTriangle::kOutside;
        if (isInside) inside.push_back(face);
        for (int k = 0; k < 3; ++k) open.emplace_back(face->neighbor(k), isInside != face->is_constrained(k));
    }
    return inside;
}

Point exact(const Predicates::Point_2& point) { return {point.x(), point.y()}; }

}  // namespace

OutlineTriangles trianglesOf(const Polygon& outline) {
    Triangulation triangulation;
    insertRing(triangulation, outline.outer);
    for (const Ring& hole : outline.holes) insertRing(triangulation, hole);
    OutlineTriangles triangles;
    for (const auto face : numberedInside(triangulation)) {
        OutlineTriangle triangle;
        for (int k = 0; k < 3; ++k) {
            const auto& from = face->vertex(Triangulation::ccw(k))->point();
            const auto& to = face->vertex(Triangulation::cw(k))->point();
            triangle.sides[static_cast<std::size_t>(k)] = Line(exact(from), exact(to));
            triangle.neighbours[static_cast<std::size_t>(k)] = face->neighbor(k)->info();
            triangle.box += from.bbox();
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

}  // namespace rubble::oracle
