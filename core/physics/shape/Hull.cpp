#include "core/physics/shape/Hull.h"

#include "core/geometry/hull/ConvexHull.h"
#include "core/physics/shape/CoplanarFaces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace rubble {
namespace {

constexpr double kWeldDistance = 1e-3;         // m
constexpr double kWeldFractionOfWidth = 0.02;  // keeps the shape of small hulls
constexpr double kPlanarDistance = 1e-6;       // m: what rounding leaves of a common plane; more would push neighbours
constexpr double kPlanarFractionOfWidth = 5e-6;  // keeps the shape of small hulls
constexpr double kCoarseDistance = 2e-4;         // m: faces so near to a common plane are one for coarseTurn
constexpr double kCoarseFractionOfWidth = 1e-3;
constexpr std::size_t kRowMultiple = 4;

double widthAlong(const Polytope& polytope, const Plane& plane) {
    double lowest = plane.offset;
    for (Vec3 vertex : polytope.vertices) lowest = std::min(lowest, glm::dot(plane.normal, vertex));
    return plane.offset - lowest;
}

double minWidthOf(const Polytope& polytope) {
    double minWidth = std::numeric_limits<double>::infinity();
    for (const Plane& plane : polytope.planes) minWidth = std::min(minWidth, widthAlong(polytope, plane));
    return minWidth;
}

/// The vertices that are not within `distance` of an earlier one.
std::vector<Vec3> weldedVertices(const Polytope& polytope, double distance) {
    std::vector<Vec3> kept;
    for (Vec3 vertex : polytope.vertices) {
        const auto isNear = [&](Vec3 other) { return glm::dot(other - vertex, other - vertex) < distance * distance; };
        if (std::none_of(kept.begin(), kept.end(), isNear)) kept.push_back(vertex);
    }
    return kept;
}

Result<Polytope> simplified(const Polytope& polytope) {
    const double minWidth = minWidthOf(polytope);
    const std::vector<Vec3> vertices =
        weldedVertices(polytope, std::min(kWeldDistance, kWeldFractionOfWidth * minWidth));
    Result<Polytope> hull =
        vertices.size() == polytope.vertices.size() ? Result<Polytope>(polytope) : convexHull(vertices);
    if (!hull) return hull;
    return mergeCoplanarFaces(*hull, std::min(kPlanarDistance, kPlanarFractionOfWidth * minWidth));
}

void append(VectorRows& rows, Vec3f v) {
    rows.x.push_back(v.x);
    rows.y.push_back(v.y);
    rows.z.push_back(v.z);
}

/// Makes room for a number of rows with their padding: a scene has many hulls, and what vectors grow by is half as much
/// again.
void reserve(VectorRows& rows, std::size_t count) {
    const std::size_t padded = (count + kRowMultiple - 1) / kRowMultiple * kRowMultiple;
    for (auto* values : {&rows.x, &rows.y, &rows.z}) values->reserve(padded);
}

void pad(VectorRows& rows, Vec3f v) {
    while (rows.x.size() % kRowMultiple != 0) append(rows, v);
}

void addCorners(Hull& hull, const Polytope& polytope, Vec3 centre) {
    reserve(hull.corners, polytope.vertices.size());
    Vec3f low(std::numeric_limits<float>::infinity()), high = -low;
    for (Vec3 vertex : polytope.vertices) {
        const Vec3f corner = toFloat(vertex - centre);
        append(hull.corners, corner);
        low = componentMin(low, corner);
        high = componentMax(high, corner);
        hull.boundingRadius = std::max(hull.boundingRadius, length(corner));
    }
    hull.cornerCount = static_cast<int>(polytope.vertices.size());
    pad(hull.corners, hull.corner(0));
    hull.middle = (low + high) * 0.5f;
    for (int i = 0; i < hull.cornerCount; ++i)
        hull.mean += hull.corner(i) * (1.0f / static_cast<float>(hull.cornerCount));
    hull.extents = (high - low) * 0.5f;
}

void addFaces(Hull& hull, const Polytope& polytope, Vec3 centre) {
    std::size_t corners = 0;
    for (const std::vector<std::uint32_t>& loop : polytope.faces) corners += loop.size();
    hull.planes.reserve(polytope.faces.size());
    hull.loops.reserve(corners);
    hull.firstInLoop.reserve(polytope.faces.size() + 1);
    hull.firstInLoop.push_back(0);
    for (std::size_t face = 0; face < polytope.faces.size(); ++face) {
        const Plane& plane = polytope.planes[face];
        const double offset = plane.offset - glm::dot(plane.normal, centre);
        hull.planes.push_back({toFloat(plane.normal), static_cast<float>(offset)});
        for (std::uint32_t vertex : polytope.faces[face]) hull.loops.push_back(static_cast<std::uint16_t>(vertex));
        hull.firstInLoop.push_back(static_cast<std::uint16_t>(hull.loops.size()));
    }
}

/// Reduced by kPlanarDistance: the plane of a merged face may lie in front of some of its corners.
float innerRadiusOf(const Hull& hull) {
    float innerRadius = hull.boundingRadius;
    for (const HullPlane& plane : hull.planes)
        innerRadius = std::min(innerRadius, plane.offset - static_cast<float>(kPlanarDistance));
    return innerRadius > 0.0f ? innerRadius : -hull.boundingRadius;
}

void addSides(Hull& hull) {
    hull.sides.reserve(hull.loops.size());
    for (int face = 0; face < static_cast<int>(hull.planes.size()); ++face) {
        const std::span<const std::uint16_t> loop = hull.face(face);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3f from = hull.corner(loop[i]), to = hull.corner(loop[i + 1 == loop.size() ? 0 : i + 1]);
            const Vec3f outwards = normalized(cross(to - from, hull.planes[face].normal));
            hull.sides.push_back({outwards, dot(outwards, from)});
        }
    }
}

/// The face whose loop runs along each directed edge.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint16_t> facesByEdge(const Polytope& polytope) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint16_t> faces;
    for (std::size_t face = 0; face < polytope.faces.size(); ++face) {
        const std::vector<std::uint32_t>& loop = polytope.faces[face];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            faces[{loop[i], loop[(i + 1) % loop.size()]}] = static_cast<std::uint16_t>(face);
        }
    }
    return faces;
}

void addEdges(Hull& hull, const Polytope& polytope) {
    const auto faces = facesByEdge(polytope);
    hull.edges.reserve(polytope.edges.size());
    for (VectorRows* rows : {&hull.edgeVectors, &hull.edgeCorners, &hull.edgeFirstNormals, &hull.edgeSecondNormals})
        reserve(*rows, polytope.edges.size());
    for (const auto& [from, to] : polytope.edges) {
        const HullEdge edge{static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to), faces.at({from, to}),
                            faces.at({to, from})};
        hull.edges.push_back(edge);
        append(hull.edgeVectors, hull.corner(edge.to) - hull.corner(edge.from));
        append(hull.edgeCorners, hull.corner(edge.from));
        append(hull.edgeFirstNormals, hull.planes[edge.firstFace].normal);
        append(hull.edgeSecondNormals, hull.planes[edge.secondFace].normal);
        const Vec3f first = hull.planes[edge.firstFace].normal, second = hull.planes[edge.secondFace].normal;
        if (dot(first, second) > 0.0f) hull.minTurn = std::min(hull.minTurn, length(cross(first, second)));
    }
    for (VectorRows* rows : {&hull.edgeVectors, &hull.edgeCorners, &hull.edgeFirstNormals, &hull.edgeSecondNormals}) {
        pad(*rows, Vec3f(0.0f));
    }
}

/// See Hull::coarseTurn.
float coarseTurnOf(const Polytope& polytope, double minWidth) {
    const Polytope merged = mergeCoplanarFaces(polytope, std::min(kCoarseDistance, kCoarseFractionOfWidth * minWidth));
    const auto faces = facesByEdge(merged);
    float least = 1.0f;
    for (const auto& [from, to] : merged.edges) {
        const Vec3f first = toFloat(merged.planes[faces.at({from, to})].normal);
        const Vec3f second = toFloat(merged.planes[faces.at({to, from})].normal);
        if (dot(first, second) > 0.0f) least = std::min(least, length(cross(first, second)));
    }
    return least;
}

}  // namespace

int Hull::farthest(Vec3f direction) const {
    int best = 0;
    float most = dot(direction, corner(0));
    for (int i = 1; i < cornerCount; ++i) {
        const float along = dot(direction, corner(i));
        if (along > most) {
            most = along;
            best = i;
        }
    }
    return best;
}

int Hull::faceAlong(Vec3f direction) const {
    int best = 0;
    float most = dot(direction, planes[0].normal);
    for (int i = 1; i < static_cast<int>(planes.size()); ++i) {
        const float along = dot(direction, planes[i].normal);
        if (along > most) {
            most = along;
            best = i;
        }
    }
    return best;
}

Result<Hull> makeHull(const Polytope& polytope, Vec3 centre) {
    if (polytope.vertices.size() > kMaxHullCorners) {
        return Error{ErrorCode::BadInput, "The hull has " + std::to_string(polytope.vertices.size()) +
                                              " corners; the simulation supports at most " +
                                              std::to_string(kMaxHullCorners) + "."};
    }
    if (polytope.vertices.size() < 4 || polytope.faces.size() < 4) {
        return Error{ErrorCode::Degenerate, "The hull needs at least four corners and four faces, but has " +
                                                std::to_string(polytope.vertices.size()) + " and " +
                                                std::to_string(polytope.faces.size()) + "."};
    }
    const Result<Polytope> simple = simplified(polytope);
    if (!simple) return simple.error();
    Hull hull;
    const double minWidth = minWidthOf(*simple);
    hull.minWidth = static_cast<float>(minWidth);
    hull.coarseTurn = coarseTurnOf(*simple, minWidth);
    addCorners(hull, *simple, centre);
    addFaces(hull, *simple, centre);
    hull.meanDepth = hull.boundingRadius;
    for (const HullPlane& plane : hull.planes)
        hull.meanDepth = std::min(hull.meanDepth, plane.offset - dot(plane.normal, hull.mean));
    hull.innerRadius = innerRadiusOf(hull);
    addSides(hull);
    addEdges(hull, *simple);
    return hull;
}

}  // namespace rubble
