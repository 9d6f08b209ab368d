#include "core/io/pack/ConvexOverlap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kOpposite = 1e-8;  // 1 + the cosine between normals: within 1.4e-4 rad

/// The part of a convex ring where normal · x <= offset.
Ring clipped(const Ring& ring, Vec2 normal, double offset) {
    Ring inside;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
        const double heightA = glm::dot(normal, a) - offset, heightB = glm::dot(normal, b) - offset;
        if (heightA <= 0.0) inside.push_back(a);
        if ((heightA < 0.0) != (heightB < 0.0) && heightA != heightB)
            inside.push_back(a + heightA / (heightA - heightB) * (b - a));
    }
    return inside;
}

/// The part of a convex ring within another, counter-clockwise one.
Ring intersection(Ring ring, const Ring& convex) {
    for (std::size_t k = 0; k < convex.size() && ring.size() >= 3; ++k) {
        const Vec2 from = convex[k], to = convex[k + 1 < convex.size() ? k + 1 : 0];
        if (from == to) continue;
        const Vec2 normal = -perpendicular(glm::normalize(to - from));
        ring = clipped(ring, normal, glm::dot(normal, from));
    }
    return ring.size() < 3 ? Ring() : ring;
}

/// A loop in coordinates of a plane with an origin and two axes.
Ring inPlane(const std::vector<Vec3>& loop, Vec3 origin, Vec3 across, Vec3 up) {
    Ring ring;
    for (const Vec3& point : loop) ring.push_back({glm::dot(point - origin, across), glm::dot(point - origin, up)});
    return ring;
}

/// The part of a ring within the sides of a prism, moved outwards.
Ring withinSides(Ring ring, const Polytope& prism, Vec3 offset, double margin) {
    for (const Plane& plane : prism.planes) {
        const Vec2 normal(plane.normal);
        const double length = glm::length(normal);
        if (length < 0.5 || ring.size() < 3) continue;  // the front or the back
        ring = clipped(ring, normal / length, (plane.offset + glm::dot(plane.normal, offset)) / length + margin);
    }
    return ring.size() < 3 ? Ring() : ring;
}

}  // namespace

std::vector<PlacedFace> placedFaces(const Polytope& hull, Vec3 offset) {
    std::vector<PlacedFace> faces;
    for (std::size_t k = 0; k < hull.faces.size(); ++k) {
        PlacedFace face{.plane = hull.planes[k], .loop = {}};
        face.plane.offset += glm::dot(face.plane.normal, offset);
        for (const std::uint32_t vertex : hull.faces[k]) face.loop.push_back(hull.vertices[vertex] + offset);
        faces.push_back(std::move(face));
    }
    return faces;
}

std::optional<FaceOverlap> overlapOf(const PlacedFace& first, const PlacedFace& second, double reach) {
    const Vec3 normal = first.plane.normal;
    if (glm::dot(normal, second.plane.normal) > kOpposite - 1.0) return std::nullopt;
    Vec3 middle(0.0);
    for (const Vec3& point : second.loop) middle += point / static_cast<double>(second.loop.size());
    const double distance = glm::dot(normal, middle) - first.plane.offset;
    if (std::abs(distance) > reach) return std::nullopt;
    const Vec3 least = std::abs(normal.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3 across = glm::normalize(glm::cross(least, normal)), up = glm::cross(normal, across);
    Ring other = inPlane(second.loop, first.loop[0], across, up);
    std::ranges::reverse(other);
    const Ring common = intersection(inPlane(first.loop, first.loop[0], across, up), other);
    return FaceOverlap{distance, common.empty() ? 0.0 : signedArea(common)};
}

double widenedOverlap(const Polytope& first, Vec3 firstOffset, const Polytope& second, Vec3 secondOffset, double margin,
                      const Box2& bounds) {
    Ring ring{bounds.min, {bounds.max.x, bounds.min.y}, bounds.max, {bounds.min.x, bounds.max.y}};
    ring = withinSides(std::move(ring), first, firstOffset, margin);
    ring = withinSides(std::move(ring), second, secondOffset, margin);
    double diameter = 0.0;
    for (const Vec2 a : ring) {
        for (const Vec2 b : ring) diameter = std::max(diameter, glm::distance(a, b));
    }
    return diameter;
}

}  // namespace rubble
