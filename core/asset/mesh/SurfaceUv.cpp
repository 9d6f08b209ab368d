#include "core/asset/mesh/SurfaceUv.h"

#include "core/base/Index.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace rubble {
namespace {

// The fraction by which a point is moved towards its face's centre before the search for the nearest triangle.
constexpr double kTowardsCentre = 1e-6;
// The cosine, of about 60 degrees, below which a triangle belongs to another face.
constexpr double kMinCosine = 0.5;

/// The barycentric coordinates of a triangle's point nearest to p.
/// Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
Vec3 nearestBarycentric(const std::array<Vec3, 3>& corners, Vec3 p) {
    const auto [a, b, c] = corners;
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
    const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
    const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
    const double areaC = d1 * d4 - d3 * d2;
    if (areaC <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
    const double areaB = d5 * d2 - d1 * d6;
    if (areaB <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
    const double areaA = d3 * d6 - d5 * d4;
    if (areaA <= 0.0 && d4 >= d3 && d5 >= d6) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - t, t};
    }
    const double sum = areaA + areaB + areaC;
    return {areaA / sum, areaB / sum, areaC / sum};
}

template <class Point>
Point blend(const std::array<Point, 3>& corners, Vec3 weights) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

double squaredDistance(const std::array<Vec3, 3>& corners, Vec3 point) {
    const Vec3 offset = blend(corners, nearestBarycentric(corners, point)) - point;
    return glm::dot(offset, offset);
}

}  // namespace

Vec2 mapped(const AffineUv& map, Vec2 point) {
    const auto& [a, b, c, d, e, f] = map.coefficients;
    return {a * point.x + b * point.y + c, d * point.x + e * point.y + f};
}

SurfaceIndex::SurfaceIndex(const Surface& surface) : m_surface(surface) {
    constexpr double kSlack = 0.99;  // for the rounding of normals
    for (std::uint32_t k = 0; k < surface.triangles.size(); ++k) {
        const auto& [a, b, c] = surface.triangles[k].corners;
        const Vec3 normal = glm::cross(b - a, c - a);
        m_normals.push_back(normal);
        const double least = kSlack * kMinCosine * glm::length(normal);
        if (normal.z > least) m_front.triangles.push_back(k);
        if (-normal.z > least) m_back.triangles.push_back(k);
        if (glm::length(Vec2(normal)) > least) m_sides.triangles.push_back(k);
    }
    for (Part* part : {&m_front, &m_back, &m_sides}) build(*part);
}

void SurfaceIndex::build(Part& part) const {
    std::vector<Box3> boxes;
    for (const std::uint32_t triangle : part.triangles) {
        Box3& box = boxes.emplace_back();
        for (const Vec3 corner : m_surface.triangles[triangle].corners) box.include(corner);
    }
    part.tree.emplace(boxes);
}

const SurfaceIndex::Part& SurfaceIndex::partFor(Vec3 normal) const {
    if (normal.z == 0.0) return m_sides;
    return normal.z > 0.0 ? m_front : m_back;
}

SurfaceSample SurfaceIndex::sample(Vec3 point, Vec3 faceCentre, Vec3 normal, std::size_t* visited) const {
    const Vec3 probe = point + kTowardsCentre * (faceCentre - point);
    const Part& part = partFor(normal);
    std::uint32_t nearest = kNone;
    double least = std::numeric_limits<double>::infinity();  // squared
    const std::size_t count = part.tree->visitNear(probe, [&](std::uint32_t k) {
        const std::uint32_t triangle = part.triangles[k];
        const Vec3 area = m_normals[triangle];
        if (glm::dot(area, normal) > kMinCosine * glm::length(area)) {
            const double distance = squaredDistance(m_surface.triangles[triangle].corners, probe);
            if (distance < least || (distance == least && triangle < nearest)) {
                least = distance;
                nearest = triangle;
            }
        }
        return std::sqrt(least);
    });
    if (visited) *visited += count;
    if (nearest == kNone) return {};
    const SurfaceTriangle& triangle = m_surface.triangles[nearest];
    return {blend(triangle.uvs, nearestBarycentric(triangle.corners, point)), triangle.material};
}

}  // namespace rubble
