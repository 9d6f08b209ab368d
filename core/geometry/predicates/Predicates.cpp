#include "core/geometry/predicates/Predicates.h"

#include "core/geometry/predicates/Expansion.h"

#include <charconv>

namespace rubble {

namespace {

constexpr double kOrient3dBound = (7.0 + 56.0 * kRounding) * kRounding;
constexpr double kNearerBound = (6.0 + 32.0 * kRounding) * kRounding;

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

struct ExactVec2 {
    Expansion<2> x, y;
};
ExactVec2 exactOffset(Vec2 a, Vec2 b) { return {exactDifference(a.x, b.x), exactDifference(a.y, b.y)}; }

Expansion<16> exactCross(const ExactVec2& a, const ExactVec2& b) { return a.x * b.y - a.y * b.x; }
Expansion<16> exactSquare(const ExactVec2& a) { return a.x * a.x + a.y * a.y; }

int orient3dExact(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const ExactVec2 ad = {exactDifference(a.x, d.x), exactDifference(a.y, d.y)};
    const ExactVec2 bd = {exactDifference(b.x, d.x), exactDifference(b.y, d.y)};
    const ExactVec2 cd = {exactDifference(c.x, d.x), exactDifference(c.y, d.y)};
    const auto first = exactCross(bd, cd) * exactDifference(a.z, d.z);
    const auto second = exactCross(cd, ad) * exactDifference(b.z, d.z);
    const auto third = exactCross(ad, bd) * exactDifference(c.z, d.z);
    return (first + second + third).sign();
}

}  // namespace

std::optional<std::string> coordinateFault(Vec2 point) {
    for (const double coordinate : {point.x, point.y}) {
        if (isExactlyUsable(coordinate)) continue;
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, coordinate).ptr;
        const std::string value(text, end);
        if (!std::isfinite(coordinate)) return "has a coordinate that is not finite: " + value;
        return "has a coordinate beyond what can be computed with (0, or 1e-60 to 1e60 in magnitude): " + value;
    }
    return std::nullopt;
}

int orient2dExact(Vec2 a, Vec2 b, Vec2 c) { return exactCross(exactOffset(a, c), exactOffset(b, c)).sign(); }

int inCircleExact(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const ExactVec2 ad = exactOffset(a, d), bd = exactOffset(b, d), cd = exactOffset(c, d);
    const auto first = exactCross(bd, cd) * exactSquare(ad);
    const auto second = exactCross(cd, ad) * exactSquare(bd);
    const auto third = exactCross(ad, bd) * exactSquare(cd);
    return (first + second + third).sign();
}

int orient2d(Vec2 a, Vec2 b, Vec2 c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    if (std::abs(determinant) > kOrientBound * (std::abs(left) + std::abs(right))) return signOf(determinant);
    return orient2dExact(a, b, c);
}

int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 ad = a - d, bd = b - d, cd = c - d;
    const double aSquare = ad.x * ad.x + ad.y * ad.y;
    const double bSquare = bd.x * bd.x + bd.y * bd.y;
    const double cSquare = cd.x * cd.x + cd.y * cd.y;
    const double determinant = aSquare * cross(bd, cd) + bSquare * cross(cd, ad) + cSquare * cross(ad, bd);
    const double magnitude = aSquare * (std::abs(bd.x * cd.y) + std::abs(bd.y * cd.x)) +
                             bSquare * (std::abs(cd.x * ad.y) + std::abs(cd.y * ad.x)) +
                             cSquare * (std::abs(ad.x * bd.y) + std::abs(ad.y * bd.x));
    if (std::abs(determinant) > kInCircleBound * magnitude) return signOf(determinant);
    return inCircleExact(a, b, c, d);
}

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 ad = a - d, bd = b - d, cd = c - d;
    const double determinant =
        ad.z * (bd.x * cd.y - bd.y * cd.x) + bd.z * (cd.x * ad.y - cd.y * ad.x) + cd.z * (ad.x * bd.y - ad.y * bd.x);
    const double magnitude = std::abs(ad.z) * (std::abs(bd.x * cd.y) + std::abs(bd.y * cd.x)) +
                             std::abs(bd.z) * (std::abs(cd.x * ad.y) + std::abs(cd.y * ad.x)) +
                             std::abs(cd.z) * (std::abs(ad.x * bd.y) + std::abs(ad.y * bd.x));
    if (std::abs(determinant) > kOrient3dBound * magnitude) return signOf(determinant);
    return orient3dExact(a, b, c, d);
}

int nearer(Vec2 p, Vec2 a, Vec2 b) {
    // |p - b|^2 - |p - a|^2 as a product of sums loses nothing where a and b are close: (a - b) · (2p - a - b).
    const Vec2 apart = a - b;
    const Vec2 toMiddle = (p - a) + (p - b);
    const double first = apart.x * toMiddle.x, second = apart.y * toMiddle.y;
    const double determinant = first + second;
    const double magnitude = std::abs(apart.x) * (std::abs(p.x - a.x) + std::abs(p.x - b.x)) +
                             std::abs(apart.y) * (std::abs(p.y - a.y) + std::abs(p.y - b.y));
    if (std::abs(determinant) > kNearerBound * magnitude) return signOf(determinant);
    const ExactVec2 ba = exactOffset(a, b), pa = exactOffset(p, a), pb = exactOffset(p, b);
    return (ba.x * (pa.x + pb.x) + ba.y * (pa.y + pb.y)).sign();
}

Vec3 exactCross(Vec3 origin, Vec3 a, Vec3 b) {
    const auto minor = [&](int i, int j) {
        const auto first = exactDifference(a[i], origin[i]) * exactDifference(b[j], origin[j]);
        const auto second = exactDifference(a[j], origin[j]) * exactDifference(b[i], origin[i]);
        return (first - second).estimate();
    };
    return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

}  // namespace rubble
