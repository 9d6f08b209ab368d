#include "core/geometry/hull/ConvexHull.h"

#include "core/base/Index.h"

#include "core/geometry/hull/HullTriangles.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <optional>
#include <utility>

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

/// Whether all corners of a triangle are within a distance, m, of the plane of another that faces the same way.
bool areNearlyCoplanar(std::span<const Vec3> points, const HullTriangle& triangle, const HullTriangle& other,
                       double tolerance) {
    const auto& [a, b, c] = triangle.corners;
    const Vec3 normal = exactCross(points[a], points[b], points[c]);
    const double most = tolerance * glm::length(normal);
    const bool isNear = std::ranges::all_of(other.corners, [&](std::uint32_t corner) {
        return std::abs(glm::dot(normal, points[corner] - points[a])) <= most;
    });
    const auto& [d, e, f] = other.corners;
    return isNear && glm::dot(normal, exactCross(points[d], points[e], points[f])) >= 0.0;
}

/// The triangles, the largest first.
std::vector<std::uint32_t> byArea(std::span<const Vec3> points, const Triangles& triangles) {
    std::vector<std::pair<double, std::uint32_t>> areas;
    for (std::uint32_t k = 0; k < triangles.size(); ++k) {
        const auto& [a, b, c] = triangles[k].corners;
        const Vec3 normal = exactCross(points[a], points[b], points[c]);
        areas.emplace_back(-glm::dot(normal, normal), k);
    }
    std::ranges::sort(areas);
    std::vector<std::uint32_t> order;
    for (const auto& [area, triangle] : areas) order.push_back(triangle);
    return order;
}

/// The face of each triangle; coplanar neighbours share one. Faces are numbered by their first triangle in `order`.
template <class AreCoplanar>
std::vector<std::uint32_t> faceOfTriangle(const Triangles& triangles, std::span<const std::uint32_t> order,
                                          AreCoplanar areCoplanar) {
    std::vector<std::uint32_t> face(triangles.size(), kNone);
    std::vector<std::uint32_t> open;
    std::uint32_t count = 0;
    for (const std::uint32_t start : order) {
        if (face[start] != kNone) continue;
        face[start] = count++;
        open.assign(1, start);
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            for (const std::uint32_t neighbour : triangles[triangle].neighbours) {
                if (face[neighbour] != kNone || !areCoplanar(triangles[start], triangles[neighbour])) continue;
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
std::vector<BoundaryEdge> boundaryEdges(const Triangles& triangles, const std::vector<std::uint32_t>& face) {
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

/// The hull of faces of triangles; its loops have to be simple.
Polytope polytopeOf(std::span<const Vec3> points, const std::vector<BoundaryEdge>& edges) {
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

/// Whether each face is surrounded by one loop that meets no point twice, and has three corners that are vertices.
bool areSimple(std::span<const BoundaryEdge> edges, const std::vector<std::uint32_t>& vertexOfPoint) {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        std::size_t corners = 0;
        for (; end < edges.size() && edges[end].face == edges[begin].face; ++end) {
            if (end > begin && edges[end].from == edges[end - 1].from) return false;
            corners += vertexOfPoint[edges[end].from] != kNone;
        }
        if (corners < 3) return false;
        std::size_t length = 0;
        std::uint32_t corner = edges[begin].from;
        do {
            const auto found = std::lower_bound(edges.begin() + static_cast<std::ptrdiff_t>(begin),
                                                edges.begin() + static_cast<std::ptrdiff_t>(end),
                                                BoundaryEdge{edges[begin].face, corner, 0});
            corner = found->to;
            ++length;
        } while (corner != edges[begin].from && length <= end - begin);
        if (length != end - begin) return false;
    }
    return true;
}

/// The hull of faces that are flat within a tolerance; nothing if they cannot be merged to one.
std::optional<Polytope> mergedHull(std::span<const Vec3> points, const Triangles& triangles, double tolerance) {
    const auto areCoplanarEnough = [&](const HullTriangle& triangle, const HullTriangle& other) {
        return areNearlyCoplanar(points, triangle, other, tolerance);
    };
    const std::vector<std::uint32_t> face = faceOfTriangle(triangles, byArea(points, triangles), areCoplanarEnough);
    const std::vector<BoundaryEdge> edges = boundaryEdges(triangles, face);
    if (edges.empty() || !areSimple(edges, vertexIndices(points.size(), edges))) return std::nullopt;
    Polytope hull = polytopeOf(points, edges);
    return verifyPolytope(hull) ? std::nullopt : std::optional(std::move(hull));
}

}  // namespace

Result<Polytope> convexHull(std::span<const Vec3> points) {
    const Result<Triangles> triangles = hullTriangles(points);
    if (!triangles) return triangles.error();
    std::vector<std::uint32_t> order(triangles->size());
    std::iota(order.begin(), order.end(), 0u);
    const auto areExactlyCoplanar = [&](const HullTriangle& triangle, const HullTriangle& other) {
        return areCoplanar(points, triangle, other);
    };
    return polytopeOf(points, boundaryEdges(*triangles, faceOfTriangle(*triangles, order, areExactlyCoplanar)));
}

Result<Polytope> convexHull(std::span<const Vec3> points, double tolerance) {
    const Result<Triangles> triangles = hullTriangles(points);
    if (!triangles) return triangles.error();
    if (std::optional<Polytope> merged = mergedHull(points, *triangles, tolerance)) return std::move(*merged);
    return convexHull(points);
}

double flatnessOf(std::span<const Vec3> points) {
    constexpr double kFlat = 1e-10;  // of the diagonal of the box around them
    if (points.empty()) return 0.0;
    Vec3 low = points[0], high = low;
    for (const Vec3& point : points) low = glm::min(low, point), high = glm::max(high, point);
    return kFlat * glm::length(high - low);
}

}  // namespace rubble
