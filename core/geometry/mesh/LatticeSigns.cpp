#include "core/geometry/mesh/LatticeSigns.h"

#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/predicates/WideInteger.h"

#include <cmath>

namespace rubble {
namespace {

/// As kOrientBound and its like, for differences without rounding.
constexpr double kVolumeBound = (7.0 + 56.0 * kRounding) * kRounding;

Int128 whole(double value) { return static_cast<std::int64_t>(value); }
template <class Number>
int signOf(Number value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Differences are below 2⁴¹, so products of three, six of them, are below 2¹²⁶.
int exactVolumeSign(Vec3 b, Vec3 c, Vec3 d) {
    const auto minor = [](Vec3 p, Vec3 q, int i, int j) {
        return whole(p[i]) * whole(q[j]) - whole(p[j]) * whole(q[i]);
    };
    return signOf(whole(b.x) * minor(c, d, 1, 2) + whole(b.y) * minor(c, d, 2, 0) + whole(b.z) * minor(c, d, 0, 1));
}

}  // namespace

int areaSign(Vec3 a, Vec3 b, Vec3 c, int axis) {
    const int i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    const double left = (b[i] - a[i]) * (c[j] - a[j]), right = (b[j] - a[j]) * (c[i] - a[i]);
    const double determinant = left - right;
    if (std::abs(determinant) > kOrientBound * (std::abs(left) + std::abs(right))) return signOf(determinant);
    return signOf(whole(b[i] - a[i]) * whole(c[j] - a[j]) - whole(b[j] - a[j]) * whole(c[i] - a[i]));
}

bool areCollinear(Vec3 a, Vec3 b, Vec3 c) {
    return areaSign(a, b, c, 0) == 0 && areaSign(a, b, c, 1) == 0 && areaSign(a, b, c, 2) == 0;
}

int volumeSign(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    b -= a, c -= a, d -= a;
    const double yz = c.y * d.z, zy = c.z * d.y, zx = c.z * d.x, xz = c.x * d.z, xy = c.x * d.y, yx = c.y * d.x;
    const double determinant = b.x * (yz - zy) + b.y * (zx - xz) + b.z * (xy - yx);
    const double magnitude = std::abs(b.x) * (std::abs(yz) + std::abs(zy)) +
                             std::abs(b.y) * (std::abs(zx) + std::abs(xz)) +
                             std::abs(b.z) * (std::abs(xy) + std::abs(yx));
    if (std::abs(determinant) > kVolumeBound * magnitude) return signOf(determinant);
    return exactVolumeSign(b, c, d);
}

AngleAround::AngleAround(Vec3 p, Vec3 q, Vec3 first) : m_p(p), m_q(q), m_first(first) {
    while (m_axis < 2 && areaSign(p, q, first, m_axis) == 0) ++m_axis;
}

/// 0 at the first point, 1 up to half a turn, 2 at it, 3 beyond.
int AngleAround::quarterOf(Vec3 point) const {
    const int side = volumeSign(m_p, m_q, m_first, point);
    if (side != 0) return side > 0 ? 1 : 3;
    return areaSign(m_p, m_q, point, m_axis) == areaSign(m_p, m_q, m_first, m_axis) ? 0 : 2;
}

int AngleAround::compare(Vec3 a, Vec3 b) const {
    const int quarterA = quarterOf(a), quarterB = quarterOf(b);
    if (quarterA != quarterB || quarterA % 2 == 0) return quarterA - quarterB;
    return -volumeSign(m_p, m_q, a, b);
}

}  // namespace rubble
