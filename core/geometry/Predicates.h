#pragma once

#include "core/geometry/Vec.h"

#include <cmath>
#include <optional>
#include <string>

namespace rubble {

/// Signs that are exact for coordinates which are zero or of a magnitude between these bounds, so that no product
/// of four coordinate differences overflows or loses bits below the smallest double.
inline constexpr double kLeastMagnitude = 1e-60;
inline constexpr double kGreatestMagnitude = 1e60;
/// True where the predicates are exact on it: finite, and zero or of a magnitude between the bounds.
inline bool isExactlyUsable(double coordinate) {
    const double magnitude = std::abs(coordinate);
    return magnitude == 0.0 || (magnitude >= kLeastMagnitude && magnitude <= kGreatestMagnitude);
}
inline bool isExactlyUsable(Vec2 point) { return isExactlyUsable(point.x) && isExactlyUsable(point.y); }
inline bool isExactlyUsable(Vec3 point) {
    return isExactlyUsable(point.x) && isExactlyUsable(point.y) && isExactlyUsable(point.z);
}

/// What keeps a point from being used, as the end of a sentence with the value in it ("has a coordinate that is not
/// finite: nan"), or nothing.
std::optional<std::string> coordinateFault(Vec2 point);

/// +1 where a, b, c turn left (counter-clockwise), -1 where they turn right, 0 where they lie on one line.
int orient2d(Vec2 a, Vec2 b, Vec2 c);

/// For counter-clockwise a, b, c: +1 where d lies inside their circle, -1 outside, 0 on it. For clockwise ones the opposite.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// +1 where d lies below the plane of a, b, c, which run counter-clockwise when seen from above; -1 above; 0 in the plane.
int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// +1 where p is nearer to a than to b, -1 where it is farther, 0 where the distances are equal.
int nearer(Vec2 p, Vec2 a, Vec2 b);

/// The cross product of a - origin and b - origin, each coordinate within one rounding of the exact value: its direction is right
/// where the three points are nearly on one line.
Vec3 exactCross(Vec3 origin, Vec3 a, Vec3 b);

/// The same signs without any filter: slower, for those who have filtered already.
int orient2dExact(Vec2 a, Vec2 b, Vec2 c);
int inCircleExact(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Half a unit in the last place of 1: the relative error of one rounding.
inline constexpr double kRounding = 0x1p-53;
/// |det| above these times the sum of the magnitudes of its products has the sign of det.
inline constexpr double kOrientBound = (3.0 + 16.0 * kRounding) * kRounding;
inline constexpr double kInCircleBound = (10.0 + 96.0 * kRounding) * kRounding;

}  // namespace rubble
