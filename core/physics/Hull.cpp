#include "core/physics/Hull.h"

#include "core/geometry/ConvexHull.h"
#include "core/physics/FaceMerging.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace rubble {
namespace {

constexpr double kMergeDistance = 1e-3;        // m
constexpr double kMergeShareOfBreadth = 0.02;  // so that small hulls keep their form
constexpr double kPlanarDistance = 1e-3;  // m: faces that are flat to that are one, as points rounded to 3 digits give
constexpr double kPlanarShareOfBreadth = 5e-3;  // for the same reason
constexpr std::size_t kRowMultiple = 4;

double widthAlong(const Polytope& polytope, const Plane& plane) {
    double lowest = plane.offset;
    for (Vec3 vertex : polytope.vertices) lowest = std::min(lowest, glm::dot(plane.normal, vertex));
    return plane.offset - lowest;
}

double breadthOf(const Polytope& polytope) {
    double breadth = std::numeric_limits<double>::infinity();
    for (const Plane& plane : polytope.planes) breadth = std::min(breadth, widthAlong(polytope, plane));
    return breadth;
}

/// The vertices without those that are nearer than `distance` to an earlier one.
std::vector<Vec3> mergedVertices(const Polytope& polytope, double distance) {
    std::vector<Vec3> kept;
    for (Vec3 vertex : polytope.vertices) {
        const auto isNear = [&](Vec3 other) { return glm::dot(other - vertex, other - vertex) < distance * distance; };
        if (std::none_of(kept.begin(), kept.end(), isNear)) kept.push_back(vertex);
    }
    return kept;
}

Result<Polytope> simplified(const Polytope& polytope) {
    const double breadth = breadthOf(polytope);
    const std::vector<Vec3> vertices =
        mergedVertices(polytope, std::min(kMergeDistance, kMergeShareOfBreadth * breadth));
    Result<Polytope> hull =
        vertices.size() == polytope.vertices.size() ? Result<Polytope>(polytope) : convexHull(vertices);
    if (!hull) return hull;
    return withMergedFaces(*hull, std::min(kPlanarDistance, kPlanarShareOfBreadth * breadth));
}

void append(VectorRows& rows, Vec3f v) {
    rows.x.push_back(v.x);
    rows.y.push_back(v.y);
    rows.z.push_back(v.z);
}

void pad(VectorRows& rows, Vec3f v) {
    while (rows.x.size() % kRowMultiple != 0) append(rows, v);
}

void addCorners(Hull& hull, const Polytope& polytope, Vec3 centre) {
    Vec3f low(std::numeric_limits<float>::infinity()), high = -low;
    for (Vec3 vertex : polytope.vertices) {
        const Vec3f corner = toFloat(vertex - centre);
        append(hull.corners, corner);
        low = leastOf(low, corner);
        high = greatestOf(high, corner);
        hull.reach = std::max(hull.reach, length(corner));
    }
    hull.cornerCount = static_cast<int>(polytope.vertices.size());
    pad(hull.corners, hull.corner(0));
    hull.middle = (low + high) * 0.5f;
    hull.extents = (high - low) * 0.5f;
}

void addFaces(Hull& hull, const Polytope& polytope, Vec3 centre) {
    hull.firstInLoop.push_back(0);
    for (std::size_t face = 0; face < polytope.faces.size(); ++face) {
        const Plane& plane = polytope.planes[face];
        const double offset = plane.offset - glm::dot(plane.normal, centre);
        hull.planes.push_back({toFloat(plane.normal), static_cast<float>(offset)});
        for (std::uint32_t vertex : polytope.faces[face]) hull.loops.push_back(static_cast<std::uint16_t>(vertex));
        hull.firstInLoop.push_back(static_cast<std::uint16_t>(hull.loops.size()));
    }
}

/// A merged face's plane may lie in front of some of its corners.
float innerOf(const Hull& hull) {
    float inner = hull.reach;
    for (const HullPlane& plane : hull.planes)
        inner = std::min(inner, plane.offset - static_cast<float>(kPlanarDistance));
    return inner > 0.0f ? inner : -hull.reach;
}

void addSides(Hull& hull) {
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
    for (const auto& [from, to] : polytope.edges) {
        const HullEdge edge{static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to), faces.at({from, to}),
                            faces.at({to, from})};
        hull.edges.push_back(edge);
        append(hull.edgeVectors, hull.corner(edge.to) - hull.corner(edge.from));
        append(hull.edgeCorners, hull.corner(edge.from));
        append(hull.edgeFirstNormals, hull.planes[edge.firstFace].normal);
        append(hull.edgeSecondNormals, hull.planes[edge.secondFace].normal);
    }
    for (VectorRows* rows : {&hull.edgeVectors, &hull.edgeCorners, &hull.edgeFirstNormals, &hull.edgeSecondNormals}) {
        pad(*rows, Vec3f(0.0f));
    }
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

int Hull::facing(Vec3f direction) const {
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
    if (polytope.vertices.size() > kMostHullCorners) {
        return Error{ErrorCode::BadInput, "A hull has " + std::to_string(polytope.vertices.size()) +
                                              " corners; the simulation takes up to " +
                                              std::to_string(kMostHullCorners) + "."};
    }
    if (polytope.vertices.size() < 4 || polytope.faces.size() < 4) {
        return Error{ErrorCode::Degenerate, "A hull needs at least four corners and four faces; it has " +
                                                std::to_string(polytope.vertices.size()) + " and " +
                                                std::to_string(polytope.faces.size()) + "."};
    }
    const Result<Polytope> simple = simplified(polytope);
    if (!simple) return simple.error();
    Hull hull;
    hull.inner = innerOf(hull);
    hull.breadth = static_cast<float>(breadthOf(*simple));
    addCorners(hull, *simple, centre);
    addFaces(hull, *simple, centre);
    addSides(hull);
    addEdges(hull, *simple);
    return hull;
}

}  // namespace rubble
