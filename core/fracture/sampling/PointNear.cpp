#include "core/fracture/sampling/PointNear.h"

#include "core/base/math/Trigonometry.h"

namespace rubble {
namespace {

constexpr int kAttempts = 50;

}  // namespace

std::optional<Vec2> pointNear(const Polygon& outline, Vec2 centre, double radius, Random& random) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const double distance = radius * random.unit(), angle = kFullTurn * random.unit();
        const Vec2 position = centre + distance * Vec2(cosine(angle), sine(angle));
        if (containment(outline, position) != Containment::Outside) return position;
    }
    return std::nullopt;
}

}  // namespace rubble
