#include "core/physics/queries/BlastPressure.h"

#include "core/base/Assert.h"

#include <array>
#include <cstddef>

namespace rubble {
namespace {

using Triangle = std::array<Vec3, 3>;

constexpr double kEdgePerDistance = 1.0 / 4.0;
constexpr double kEdgeAtRadius = 1.0 / 32.0;  // per distance: where the impulse per area has a kink
constexpr int kMaxDivisions = 64;             // two halve the edges: from 400 m to 0.1 µm
constexpr double kMinDistance = 1e-9;         // m: a point is the centre of the blast

/// Adds the impulse on a small area, given as its vector.
void addAt(Vec3 point, Vec3 area, const BlastPressure& blast, BlastSum& sum) {
    const double distance = glm::length(point);
    if (distance < kMinDistance || distance >= blast.radius) return;
    const Vec3 direction = point / distance;
    const double facing = -glm::dot(area, direction);
    const Vec3 impulse = direction * (blast.impulse * (1.0 - distance / blast.radius) * facing);
    const double size = glm::length(impulse);
    sum.impulse += impulse;
    sum.size += size;
    sum.weightedPoint += size * point;
}

/// Integrates by the middles of the edges, which is exact for quadratic functions.
void addSmall(const Triangle& triangle, const BlastPressure& blast, BlastSum& sum) {
    const Vec3 area = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) / 2.0;
    for (std::size_t k = 0; k < 3; ++k) addAt((triangle[k] + triangle[(k + 1) % 3]) / 2.0, area / 3.0, blast, sum);
}

std::size_t longestEdge(const Triangle& triangle) {
    std::size_t longest = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 edge = triangle[(k + 1) % 3] - triangle[k];
        if (glm::dot(edge, edge) <= most) continue;
        most = glm::dot(edge, edge);
        longest = k;
    }
    return longest;
}

/// Halves triangles at their longest edge until they are small.
void addTriangle(const Triangle& triangle, const BlastPressure& blast, int divisions, BlastSum& sum) {
    const std::size_t k = longestEdge(triangle);
    const Vec3 from = triangle[k], to = triangle[(k + 1) % 3], apex = triangle[(k + 2) % 3];
    const double length = glm::distance(from, to), distance = glm::length((from + to + apex) / 3.0);
    if (distance - length > blast.radius) return;
    const double most = (distance + length < blast.radius ? kEdgePerDistance : kEdgeAtRadius) * distance;
    if (divisions == kMaxDivisions || length < most) return addSmall(triangle, blast, sum);
    const Vec3 middle = (from + to) / 2.0;
    addTriangle({from, middle, apex}, blast, divisions + 1, sum);
    addTriangle({middle, to, apex}, blast, divisions + 1, sum);
}

}  // namespace

void addBlastOn(const FacePolygon& part, const BlastPressure& blast, BlastSum& sum) {
    RUBBLE_ASSERT(blast.radius > 0.0);
    for (std::size_t k = 2; k < part.size(); ++k) addTriangle({part[0], part[k - 1], part[k]}, blast, 0, sum);
}

}  // namespace rubble
