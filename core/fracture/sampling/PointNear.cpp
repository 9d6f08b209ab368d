#include "core/fracture/sampling/PointNear.h"

#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kAttempts = 50;

/// A uniform random unit vector, from two random numbers.
Vec3 randomDirection(Random& random) {
    const double height = 2.0 * random.unit() - 1.0, angle = kFullTurn * random.unit();
    const double across = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {across * cosine(angle), across * sine(angle), height};
}

}  // namespace

std::optional<Vec2> pointNear(const Polygon& outline, Vec2 centre, double radius, Random& random) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const double distance = radius * random.unit(), angle = kFullTurn * random.unit();
        const Vec2 position = centre + distance * Vec2(cosine(angle), sine(angle));
        if (containment(outline, position) != Containment::Outside) return position;
    }
    return std::nullopt;
}

std::optional<Vec3> pointNear(const SolidDomain& domain, Vec3 centre, double radius, Random& random) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const double distance = radius * random.unit();
        const Vec3 position = centre + distance * randomDirection(random);
        if (domain.contains(position)) return position;
    }
    return domain.pointNear(centre, radius * random.unit(), random);
}

}  // namespace rubble
