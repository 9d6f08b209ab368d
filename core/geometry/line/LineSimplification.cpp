#include "core/geometry/line/LineSimplification.h"

#include "core/geometry/predicates/SegmentDistance.h"

#include <cstddef>

namespace rubble {

namespace {

/// Marks the points between `first` and `last` to keep, so that the simplified line stays within `tolerance`.
/// Source: Ramer 1972; Douglas, Peucker 1973.
void keepCorners(const std::vector<Vec2>& points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& isKept) {
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t k = first + 1; k < last; ++k) {
        const double off = distanceToSegment(points[k], points[first], points[last]);
        if (off <= most) continue;
        most = off;
        farthest = k;
    }
    if (farthest == first) return;
    isKept[farthest] = true;
    keepCorners(points, first, farthest, tolerance, isKept);
    keepCorners(points, farthest, last, tolerance, isKept);
}

}  // namespace

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance) {
    std::vector<bool> isKept(points.size(), false);
    isKept.front() = isKept.back() = true;
    keepCorners(points, 0, points.size() - 1, tolerance, isKept);
    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (isKept[k] && (kept.empty() || kept.back() != points[k])) kept.push_back(points[k]);
    }
    return kept;
}

}  // namespace rubble
