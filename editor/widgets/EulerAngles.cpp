#include "editor/widgets/EulerAngles.h"

#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kResolution = 1e-10;        // degrees
constexpr double kGimbalLock = 1.0 - 1e-12;  // sine of y

/// A rotation about a world axis.
Quat rotation(double degrees, int axis) {
    const double whole = std::remainder(degrees, 720.0);  // the period of a quaternion
    const double half = whole / 2.0 / kDegreesPerRadian;
    double s = sine(half);
    double c = cosine(half);
    if (std::abs(whole) == 180.0) c = 0.0;
    if (whole == 0.0) s = 0.0;
    Quat quat{c, 0.0, 0.0, 0.0};
    quat[axis] = s;  // x, y, z, w
    return quat;
}

double rounded(double degrees) {
    const double value = std::round(degrees / kResolution) * kResolution;
    const double whole = std::round(degrees);
    if (std::abs(degrees - whole) < 10.0 * kResolution) return whole + 0.0;
    return value;
}

}  // namespace

Quat orientationOf(Vec3 degrees) {
    return glm::normalize(rotation(degrees.z, 2) * rotation(degrees.y, 1) * rotation(degrees.x, 0));
}

Vec3 eulerDegrees(const Quat& q) {
    const double sineOfY = std::clamp(2.0 * (q.w * q.y - q.z * q.x), -1.0, 1.0);
    Vec3 radians{0.0, std::asin(sineOfY), 0.0};
    if (std::abs(sineOfY) < kGimbalLock) {
        radians.x = std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y));
        radians.z = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    } else {
        radians.x = 2.0 * std::atan2(q.x, q.w);
    }
    return {rounded(radians.x * kDegreesPerRadian), rounded(radians.y * kDegreesPerRadian),
            rounded(radians.z * kDegreesPerRadian)};
}

}  // namespace rubble
