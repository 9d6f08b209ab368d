#include "core/geometry/hull/ConvexHull.h"

#include "core/base/Index.h"

#include "core/geometry/hull/HullTriangles.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <compare>

namespace rubble {

namespace {

using Loop = std::vector<std::uint32_t>;
using Triangles = std::vector<HullTriangle>;

// A cross product smaller than this, relative to its factors, has lost half of its digits and is computed exactly.
constexpr double kNeedle = 1e-8;

bool areCoplanar(std::span<const Vec3> points, const HullTriangle& triangle, const HullTriangle& other) {
    const std::array<std::uint32_t, 3>& base = triangle.corners;
    return std::all_of(other.corners.begin(), other.corners.end(), [&](std::uint32_t corner) {
        return std::find(base.begin(), base.end(), corner) != base.end() ||
               orient3d(points[base[0]], points[base[1]], points[base[2]], points[corner]) == 0;
    });
}

/// The face of each triangle; coplanar neighbours share one. Faces are numbered by their first triangle.
std::vector<std::uint32_t> faceOfTriangle(std::span<const Vec3> points, const Triangles& triangles) {
    std::vector<std::uint32_t> face(triangles.size(), kNone);
    std::vector<std::uint32_t> open;
    std::uint32_t count = 0;
    for (std::uint32_t start = 0; start < triangles.size(); ++start) {
        if (face[start] != kNone) continue;
        face[start] = count++;
        open.assign(1, start);
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            for (const std::uint32_t neighbour : triangles[triangle].neighbours) {
                if (face[neighbour] != kNone || !areCoplanar(points, triangles[start], triangles[neighbour])) continue;
                face[neighbour] = face[start];
                open.push_back(neighbour);
            }
        }
    }
    return face;
}

struct BoundaryEdge {
    std::uint32_t face;
    std::uint32_t from;
    std::uint32_t to;
    auto operator<=>(const BoundaryEdge&) const = default;
};

/// The edges between different faces, sorted by face, then start.
std::vector<BoundaryEdge> boundaryEdges(std::span<const Vec3> points, const Triangles& triangles) {
    const std::vector<std::uint32_t> face = faceOfTriangle(points, triangles);
    std::vector<BoundaryEdge> edges;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (face[triangles[triangle].neighbours[i]] == face[triangle]) continue;
            const auto& corners = triangles[triangle].corners;
            edges.push_back({face[triangle], corners[i], corners[(i + 1) % 3]});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// The vertex index of each point with at least three faces, in input order; a point with two faces is in the interior
/// of an edge.
std::vector<std::uint32_t> vertexIndices(std::size_t pointCount, std::span<const BoundaryEdge> edges) {
    std::vector<std::uint32_t> indices(pointCount, 0);
    for (const BoundaryEdge& edge : edges) ++indices[edge.from];
    std::uint32_t count = 0;
    for (std::uint32_t& index : indices) index = index >= 3 ? count++ : kNone;
    return indices;
}

/// The loop of a face, from its edges sorted by start: the corners that are vertices, the lowest first.
Loop loopOf(std::span<const BoundaryEdge> edges, const std::vector<std::uint32_t>& vertexOfPoint) {
    Loop loop;
    const std::uint32_t start = edges[0].from;
    std::uint32_t corner = start;
    do {
        if (vertexOfPoint[corner] != kNone) loop.push_back(vertexOfPoint[corner]);
        const auto edge = std::lower_bound(edges.begin(), edges.end(), BoundaryEdge{edges[0].face, corner, 0});
        corner = edge->to;
    } while (corner != start);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    return loop;
}

/// The plane of a face, from the largest triangle of its first corner and an edge.
Plane planeOf(std::span<const Vec3> vertices, const Loop& loop) {
    const Vec3 origin = vertices[loop[0]];
    std::size_t best = 1;
    double most = -1.0;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        const Vec3 normal = glm::cross(vertices[loop[k]] - origin, vertices[loop[k + 1]] - origin);
        const double size = glm::dot(normal, normal);
        if (size <= most) continue;
        best = k;
        most = size;
    }
    const Vec3 a = vertices[loop[best]];
    const Vec3 b = vertices[loop[best + 1]];
    const bool isNeedle =
        !(most > kNeedle * kNeedle * glm::dot(a - origin, a - origin) * glm::dot(b - origin, b - origin));
    const Vec3 normal = glm::normalize(isNeedle ? exactCross(origin, a, b) : glm::cross(a - origin, b - origin));
    return {normal, glm::dot(normal, origin)};
}

void addEdges(Polytope& polytope) {
    for (const Loop& loop : polytope.faces) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t next = loop[(k + 1) % loop.size()];
            if (loop[k] < next) polytope.edges.push_back({loop[k], next});
        }
    }
    std::sort(polytope.edges.begin(), polytope.edges.end());
}

}  // namespace

Result<Polytope> convexHull(std::span<const Vec3> points) {
    const Result<std::vector<HullTriangle>> triangles = hullTriangles(points);
    if (!triangles) return triangles.error();
    const std::vector<BoundaryEdge> edges = boundaryEdges(points, *triangles);
    const std::vector<std::uint32_t> vertexOfPoint = vertexIndices(points.size(), edges);
    Polytope polytope;
    for (std::size_t point = 0; point < points.size(); ++point) {
        if (vertexOfPoint[point] != kNone) polytope.vertices.push_back(points[point]);
    }
    for (auto first = edges.begin(); first != edges.end();) {
        const auto isOther = [&](const BoundaryEdge& edge) { return edge.face != first->face; };
        const auto last = std::find_if(first, edges.end(), isOther);
        polytope.faces.push_back(loopOf({first, last}, vertexOfPoint));
        first = last;
    }
    std::sort(polytope.faces.begin(), polytope.faces.end());
    for (const Loop& loop : polytope.faces) polytope.planes.push_back(planeOf(polytope.vertices, loop));
    addEdges(polytope);
    return polytope;
}

}  // namespace rubble
