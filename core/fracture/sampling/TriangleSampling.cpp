#include "core/fracture/sampling/TriangleSampling.h"

#include <algorithm>

namespace rubble {

std::size_t drawByWeight(std::span<const double> sums, Random& random) {
    const double drawn = random.unit() * sums.back();
    const auto found = std::ranges::upper_bound(sums, drawn) - sums.begin();
    return std::min(sums.size() - 1, static_cast<std::size_t>(found));  // the last one where rounding reaches the sum
}

Vec2 pointOfTriangle(Vec2 corner, Vec2 first, Vec2 second, Random& random) {
    double u = random.unit();
    double v = random.unit();
    if (u + v > 1.0) {  // the other half of the parallelogram, mirrored onto the triangle
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return corner + u * first + v * second;
}

}  // namespace rubble
