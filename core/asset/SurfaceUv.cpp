#include "core/asset/SurfaceUv.h"

#include <algorithm>
#include <limits>

namespace rubble {

namespace {

// How far a point is drawn towards its face's centre before the nearest triangle is looked for.
constexpr double kTowardsCentre = 1e-6;
// Triangles turned away from a face by more than this are other faces: cosine of about 60 degrees.
constexpr double kSameWay = 0.5;

/// The weights of a triangle's corners at its point nearest to p.
/// Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
Vec3 nearestWeights(const std::array<Vec3, 3>& corners, Vec3 p) {
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
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - share, share};
    }
    const double sum = areaA + areaB + areaC;
    return {areaA / sum, areaB / sum, areaC / sum};
}

template <class Point>
Point blend(const std::array<Point, 3>& corners, Vec3 weights) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

double squaredDistance(const std::array<Vec3, 3>& corners, Vec3 point) {
    const Vec3 offset = blend(corners, nearestWeights(corners, point)) - point;
    return glm::dot(offset, offset);
}

bool facesTheSameWay(const std::array<Vec3, 3>& corners, Vec3 normal) {
    const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return glm::dot(area, normal) > kSameWay * glm::length(area);
}

}  // namespace

Vec2 mapped(const AffineUv& map, Vec2 point) {
    const auto& [a, b, c, d, e, f] = map.coefficients;
    return {a * point.x + b * point.y + c, d * point.x + e * point.y + f};
}

SurfaceLook surfaceLook(const Surface& surface, Vec3 point, Vec3 faceCentre, Vec3 normal) {
    const Vec3 probe = point + kTowardsCentre * (faceCentre - point);
    const SurfaceTriangle* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const SurfaceTriangle& triangle : surface.triangles) {
        if (!facesTheSameWay(triangle.corners, normal)) continue;
        const double distance = squaredDistance(triangle.corners, probe);
        if (!(distance < least)) continue;
        least = distance;
        nearest = &triangle;
    }
    if (!nearest) return {};
    return {blend(nearest->uvs, nearestWeights(nearest->corners, point)), nearest->material};
}

}  // namespace rubble
