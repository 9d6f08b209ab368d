#pragma once

#include "core/geometry/predicates/Vec.h"

#include <cmath>
#include <optional>
#include <string>

namespace rubble {

/// The predicates are exact for coordinates that are zero or of a magnitude between these bounds, for which no product
/// of four coordinate differences overflows or underflows.
inline constexpr double kMinMagnitude = 1e-60;
inline constexpr double kMaxMagnitude = 1e60;
/// Whether the predicates are exact for a coordinate: finite, and zero or within the bounds.
inline bool isExactlyUsable(double coordinate) {
    const double magnitude = std::abs(coordinate);
    return magnitude == 0.0 || (magnitude >= kMinMagnitude && magnitude <= kMaxMagnitude);
}
inline bool isExactlyUsable(Vec2 point) { return isExactlyUsable(point.x) && isExactlyUsable(point.y); }
inline bool isExactlyUsable(Vec3 point) {
    return isExactlyUsable(point.x) && isExactlyUsable(point.y) && isExactlyUsable(point.z);
}

/// Why a point is not exactly usable, as the end of a sentence ("has a coordinate that is not finite: nan"); nothing if
/// it is.
std::optional<std::string> coordinateFault(Vec2 point);

/// +1 if a, b, c are counter-clockwise, -1 if clockwise, 0 if collinear.
int orient2d(Vec2 a, Vec2 b, Vec2 c);

/// For counter-clockwise a, b, c: +1 if d lies inside their circumcircle, -1 outside, 0 on it. Negated for clockwise
/// ones.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// +1 if d lies below the plane of a, b, c, which are counter-clockwise seen from above; -1 above; 0 in the plane.
int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// +1 if p is nearer to a than to b, -1 if it is farther, 0 if equidistant.
int nearer(Vec2 p, Vec2 a, Vec2 b);

/// The cross product of a - origin and b - origin, each coordinate with an error of at most 1 ulp: its direction is
/// accurate even for nearly collinear points.
Vec3 exactCross(Vec3 origin, Vec3 a, Vec3 b);

/// The same predicates without a floating-point filter, for callers that have already filtered.
int orient2dExact(Vec2 a, Vec2 b, Vec2 c);
int inCircleExact(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Half an ulp of 1: the relative error of one rounding.
inline constexpr double kRounding = 0x1p-53;
/// Filter bounds: if |det| exceeds the bound times the sum of the magnitudes of its products, its sign is exact.
inline constexpr double kOrientBound = (3.0 + 16.0 * kRounding) * kRounding;
inline constexpr double kInCircleBound = (10.0 + 96.0 * kRounding) * kRounding;

}  // namespace rubble
