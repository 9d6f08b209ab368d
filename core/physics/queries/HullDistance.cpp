#include "core/physics/queries/HullDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

double squaredDistanceToSegment(Vec3 from, Vec3 to, Vec3 point) {
    const Vec3 along = to - from, offset = point - from;
    const double squaredLength = glm::dot(along, along);
    const double fraction = squaredLength > 0.0 ? std::clamp(glm::dot(offset, along) / squaredLength, 0.0, 1.0) : 0.0;
    const Vec3 nearest = offset - fraction * along;
    return glm::dot(nearest, nearest);
}

/// `height`: of the point over the face's plane.
double squaredDistanceToFace(const Hull& hull, int face, Vec3 point, double height) {
    const std::span<const std::uint16_t> loop = hull.face(face);
    const auto isBehind = [&](const HullPlane& side) { return glm::dot(toDouble(side.normal), point) <= side.offset; };
    if (std::ranges::all_of(hull.sidesOf(face), isBehind)) return height * height;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 from = toDouble(hull.corner(loop[k])), to = toDouble(hull.corner(loop[(k + 1) % loop.size()]));
        least = std::min(least, squaredDistanceToSegment(from, to, point));
    }
    return least;
}

}  // namespace

double distanceTo(const Hull& hull, Vec3 point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t face = 0; face < hull.planes.size(); ++face) {
        const HullPlane& plane = hull.planes[face];
        const double height = glm::dot(toDouble(plane.normal), point) - plane.offset;
        if (height > 0.0) least = std::min(least, squaredDistanceToFace(hull, static_cast<int>(face), point, height));
    }
    return std::isfinite(least) ? std::sqrt(least) : 0.0;  // inside, no face is seen
}

}  // namespace rubble
