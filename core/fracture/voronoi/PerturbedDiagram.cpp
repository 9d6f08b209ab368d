#include "core/fracture/voronoi/PerturbedDiagram.h"

#include "core/geometry/predicates/Expansion.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

constexpr double kSideBound = 24.0 * kRounding;  // more roundings than any expression below has
constexpr double kOrderBound = 24.0 * kRounding;

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }
double absoluteCross(Vec2 a, Vec2 b) { return std::abs(a.x * b.y) + std::abs(a.y * b.x); }
double absoluteDot(Vec2 a, Vec2 b) { return std::abs(a.x * b.x) + std::abs(a.y * b.y); }

/// A vector whose coordinates are exact sums of N terms.
template <int N>
struct ExactVec {
    Expansion<N> x, y;
};
ExactVec<2> exactOffset(Vec2 from, Vec2 to) { return {exactDifference(to.x, from.x), exactDifference(to.y, from.y)}; }
template <int N, int M>
auto exactCross(const ExactVec<N>& a, const ExactVec<M>& b) {
    return a.x * b.y - a.y * b.x;
}
template <int N, int M>
auto exactDot(const ExactVec<N>& a, const ExactVec<M>& b) {
    return a.x * b.x + a.y * b.y;
}
template <int N, int M>
ExactVec<N + M> sum(const ExactVec<N>& a, const ExactVec<M>& b) {
    return {a.x + b.x, a.y + b.y};
}

/// The circumcentre of (0, b, c) is numerator / denominator.
template <int N>
auto circumcentreNumerator(const ExactVec<N>& b, const ExactVec<N>& c) {
    const auto bSquare = exactDot(b, b), cSquare = exactDot(c, c);
    const auto x = bSquare * c.y - cSquare * b.y;
    const auto y = cSquare * b.x - bSquare * c.x;
    return ExactVec<std::tuple_size_v<decltype(x.terms)>>{x, y};
}

/// A number in double-double arithmetic: its error is 2^-100 of the magnitudes of the operands. `high` is the rounded
/// sum.
struct DoubleDouble {
    double high, low;
};
DoubleDouble doubleDouble(SumAndError parts, double error) {
    const SumAndError whole = twoSum(parts.sum, parts.error + error);
    return {whole.sum, whole.error};
}
DoubleDouble operator+(DoubleDouble a, DoubleDouble b) { return doubleDouble(twoSum(a.high, b.high), a.low + b.low); }
DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + DoubleDouble{-b.high, -b.low}; }
DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    return doubleDouble(twoProduct(a.high, b.high), a.high * b.low + a.low * b.high);
}
DoubleDouble doubleDoubleDifference(double a, double b) { return doubleDouble(twoSum(a, -b), 0.0); }

/// The estimate() of the exact a - b, or nothing if it is not certain. The estimate is the exact value rounded, unless
/// the value is within 2^-75 of itself from the midpoint of two doubles: its largest term is off by at most 2^-44 of a
/// and b, which then is 2^-24 of the value, and adding the rest to that term is one rounding of that size.
std::optional<double> roundedDifference(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble difference = a - b;
    const double magnitude = std::abs(difference.high), margin = 0x1p-70 * magnitude;
    const bool isCancelled = magnitude <= 0x1p-20 * (std::abs(a.high) + std::abs(b.high));
    const bool isCertain = difference.high + (difference.low + margin) == difference.high &&
                           difference.high + (difference.low - margin) == difference.high;
    return isCertain && !isCancelled ? std::optional(difference.high) : std::nullopt;
}

/// The circumcentre of (0, b - a, c - a) is numerator / (2 * cross), all three rounded from their exact values.
struct Circumcentre {
    Vec2 numerator;
    double cross;
};
/// By double-double arithmetic first, which is nearly always enough.
Circumcentre roundedCircumcentre(Vec2 a, Vec2 b, Vec2 c) {
    const DoubleDouble bx = doubleDoubleDifference(b.x, a.x), by = doubleDoubleDifference(b.y, a.y);
    const DoubleDouble cx = doubleDoubleDifference(c.x, a.x), cy = doubleDoubleDifference(c.y, a.y);
    const DoubleDouble bSquare = bx * bx + by * by, cSquare = cx * cx + cy * cy;
    const std::optional<double> x = roundedDifference(bSquare * cy, cSquare * by);
    const std::optional<double> y = roundedDifference(cSquare * bx, bSquare * cx);
    const std::optional<double> product = roundedDifference(bx * cy, by * cx);
    if (x && y && product) return {{*x, *y}, *product};
    const auto ab = exactOffset(a, b), ac = exactOffset(a, c);
    const auto exact = circumcentreNumerator(ab, ac);
    return {{exact.x.estimate(), exact.y.estimate()}, exactCross(ab, ac).estimate()};
}

/// cross(line, circumcentre - line.from) times twice the triangle's doubled area, exactly.
int sideOfCircumcentreExact(const DirectedLine& line, Vec2 a, Vec2 b, Vec2 c) {
    const auto direction = exactOffset(line.from, line.to);
    const auto ab = exactOffset(a, b), ac = exactOffset(a, c);
    const auto denominator = scaled(exactCross(ab, ac), 2.0);
    const auto toA = exactCross(direction, exactOffset(line.from, a)) * denominator;
    const auto toCentre = exactCross(direction, circumcentreNumerator(ab, ac));
    return (toA + toCentre).sign();
}

int sideOfCircumcentre(const DirectedLine& line, Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 direction = line.to - line.from, toA = a - line.from;
    const Vec2 ab = b - a, ac = c - a;
    const double bSquare = ab.x * ab.x + ab.y * ab.y, cSquare = ac.x * ac.x + ac.y * ac.y;
    const Vec2 numerator = {bSquare * ac.y - cSquare * ab.y, cSquare * ab.x - bSquare * ac.x};
    const Vec2 bound = {bSquare * std::abs(ac.y) + cSquare * std::abs(ab.y),
                        cSquare * std::abs(ab.x) + bSquare * std::abs(ac.x)};
    const double determinant = 2.0 * cross(ab, ac) * cross(direction, toA) + cross(direction, numerator);
    const double magnitude =
        2.0 * absoluteCross(ab, ac) * absoluteCross(direction, toA) + absoluteCross(direction, bound);
    if (std::abs(determinant) > kSideBound * magnitude) return signOf(determinant);
    return sideOfCircumcentreExact(line, a, b, c);
}

int signOfDot(Vec2 aFrom, Vec2 aTo, Vec2 bFrom, Vec2 bTo) {
    const Vec2 a = aTo - aFrom, b = bTo - bFrom;
    const double value = a.x * b.x + a.y * b.y;
    if (std::abs(value) > kSideBound * absoluteDot(a, b)) return signOf(value);
    return exactDot(exactOffset(aFrom, aTo), exactOffset(bFrom, bTo)).sign();
}
int signOfCross(Vec2 aFrom, Vec2 aTo, Vec2 bFrom, Vec2 bTo) {
    const Vec2 a = aTo - aFrom, b = bTo - bFrom;
    const double value = cross(a, b);
    if (std::abs(value) > kSideBound * absoluteCross(a, b)) return signOf(value);
    return exactCross(exactOffset(aFrom, aTo), exactOffset(bFrom, bTo)).sign();
}

/// A line crosses the bisector of i and j at midpoint + s * perpendicular(j - i), s = numerator / denominator / 2.
struct ExactIntersection {
    Expansion<32> numerator;
    Expansion<16> denominator;
};
ExactIntersection exactIntersection(const DirectedLine& line, Vec2 i, Vec2 j) {
    const auto direction = exactOffset(line.from, line.to);
    const auto fromMidpointTwice = sum(exactOffset(i, line.from), exactOffset(j, line.from));
    return {exactCross(direction, fromMidpointTwice), exactDot(direction, exactOffset(i, j))};
}

/// Sign of s(first) - s(second).
int orderAlongBisectorExact(Vec2 i, Vec2 j, const DirectedLine& first, const DirectedLine& second) {
    const ExactIntersection a = exactIntersection(first, i, j), b = exactIntersection(second, i, j);
    const int sign = (a.numerator * b.denominator - b.numerator * a.denominator).sign();
    return sign * a.denominator.sign() * b.denominator.sign();
}

int orderAlongBisector(Vec2 i, Vec2 j, const DirectedLine& first, const DirectedLine& second) {
    const Vec2 apart = j - i;
    const auto terms = [&](const DirectedLine& line) {
        const Vec2 direction = line.to - line.from, fromMidpointTwice = (line.from - i) + (line.from - j);
        const Vec2 bound = {std::abs(line.from.x - i.x) + std::abs(line.from.x - j.x),
                            std::abs(line.from.y - i.y) + std::abs(line.from.y - j.y)};
        return std::array{cross(direction, fromMidpointTwice), direction.x * apart.x + direction.y * apart.y,
                          absoluteCross(direction, bound), absoluteDot(direction, apart)};
    };
    const auto [n1, d1, nBound1, dBound1] = terms(first);
    const auto [n2, d2, nBound2, dBound2] = terms(second);
    const double determinant = n1 * d2 - n2 * d1;
    const bool isCertain = std::abs(determinant) > kOrderBound * (nBound1 * dBound2 + nBound2 * dBound1) &&
                           std::abs(d1) > kOrderBound * dBound1 && std::abs(d2) > kOrderBound * dBound2;
    if (isCertain) return signOf(determinant) * signOf(d1) * signOf(d2);
    return orderAlongBisectorExact(i, j, first, second);
}

/// How s changes as the bisector moves from i towards j: sign of s'(first) - s'(second), s' = -cross / dot.
int orderOfMovingIntersections(Vec2 i, Vec2 j, const DirectedLine& first, const DirectedLine& second) {
    const auto apart = exactOffset(i, j);
    const auto a = exactOffset(first.from, first.to), b = exactOffset(second.from, second.to);
    const auto aDot = exactDot(a, apart), bDot = exactDot(b, apart);
    const int sign = (exactCross(b, apart) * aDot - exactCross(a, apart) * bDot).sign();
    return sign * aDot.sign() * bDot.sign();
}

}  // namespace

int PerturbedDiagram::sideOfCorner(const DirectedLine& line, std::uint32_t triangle) const {
    const Delaunay::Triangle& t = m_delaunay.triangles[triangle];
    for (int k = 0; k < 3; ++k) {
        if (t.corner[k] == kGhost) return sideOfInfinity(line, t.corner[(k + 1) % 3], t.corner[(k + 2) % 3]);
    }
    const UninitializedVector<Vec2>& sites = m_delaunay.sites;
    const int side = sideOfCircumcentre(line, sites[t.corner[0]], sites[t.corner[1]], sites[t.corner[2]]);
    return side != 0 ? side : sideOfTiedCorner(line, t);
}

/// The corner lies on the line. As the cell of a grows, the corner moves away from a, perpendicular to the opposite
/// edge; the lowest index that moves it off the line decides.
int PerturbedDiagram::sideOfTiedCorner(const DirectedLine& line, const Delaunay::Triangle& triangle) const {
    std::array<int, 3> byIndex = {0, 1, 2};
    std::sort(byIndex.begin(), byIndex.end(), [&](int a, int b) {
        return m_delaunay.seedOf[triangle.corner[a]] < m_delaunay.seedOf[triangle.corner[b]];
    });
    for (const int k : byIndex) {
        const Vec2 start = m_delaunay.sites[triangle.corner[(k + 1) % 3]];
        const Vec2 end = m_delaunay.sites[triangle.corner[(k + 2) % 3]];
        if (const int side = -signOfDot(line.from, line.to, start, end)) return side;
    }
    return 1;  // unreachable: the line is perpendicular to at most one edge direction
}

/// For the point at infinity left of a -> b, along the bisector of a and b.
int PerturbedDiagram::sideOfInfinity(const DirectedLine& line, std::uint32_t a, std::uint32_t b) const {
    const Vec2 start = m_delaunay.sites[a], end = m_delaunay.sites[b];
    if (const int side = signOfDot(line.from, line.to, start, end)) return side;
    // The line is parallel to the bisector: the side of the bisector decides, and if the line is the bisector, the side
    // to which the bisector moves, away from the lower index.
    const auto direction = exactOffset(line.from, line.to);
    const auto toMidpointTwice = sum(exactOffset(line.from, start), exactOffset(line.from, end));
    if (const int side = exactCross(direction, toMidpointTwice).sign()) return side;
    const bool startIsLower = m_delaunay.seedOf[a] < m_delaunay.seedOf[b];
    return (startIsLower ? 1 : -1) * signOfCross(line.from, line.to, start, end);
}

bool PerturbedDiagram::isNearer(Vec2 point, std::uint32_t i, std::uint32_t j) const {
    const int sign = nearer(point, m_delaunay.sites[i], m_delaunay.sites[j]);
    return sign != 0 ? sign > 0 : m_delaunay.seedOf[i] < m_delaunay.seedOf[j];
}

bool PerturbedDiagram::crossesBefore(std::uint32_t i, std::uint32_t j, const DirectedLine& first,
                                     const DirectedLine& second) const {
    const Vec2 a = m_delaunay.sites[i], b = m_delaunay.sites[j];
    if (const int order = orderAlongBisector(a, b, first, second)) return order < 0;
    const int order = orderOfMovingIntersections(a, b, first, second);
    return (m_delaunay.seedOf[i] < m_delaunay.seedOf[j] ? order : -order) < 0;
}

Vec2 circumcentreExactly(Vec2 a, Vec2 b, Vec2 c, Vec2 origin) {
    const Circumcentre centre = roundedCircumcentre(a, b, c);
    const double denominator = 2.0 * centre.cross;
    return (a - origin) + Vec2{centre.numerator.x / denominator, centre.numerator.y / denominator};
}

Vec2 intersectionWithBisector(const DirectedLine& line, Vec2 a, Vec2 b, Vec2 origin, double boundingRadius) {
    const Vec2 direction = line.to - line.from, apart = b - a;
    const Vec2 toMidpointTwice = (a - line.from) + (b - line.from);
    const Vec2 bound = {std::abs(a.x - line.from.x) + std::abs(b.x - line.from.x),
                        std::abs(a.y - line.from.y) + std::abs(b.y - line.from.y)};
    const double denominator = 2.0 * (direction.x * apart.x + direction.y * apart.y);
    double along = (apart.x * toMidpointTwice.x + apart.y * toMidpointTwice.y) / denominator;
    const double error = 8.0 * kRounding * (absoluteDot(apart, bound) + 2.0 * absoluteDot(direction, apart)) /
                         std::abs(denominator) * std::max(std::abs(direction.x), std::abs(direction.y));
    if (!(error <= kConstructionError * boundingRadius)) {
        const auto exactApart = exactOffset(a, b);
        const auto exactTwice = sum(exactOffset(line.from, a), exactOffset(line.from, b));
        const double exactDenominator = 2.0 * exactDot(exactOffset(line.from, line.to), exactApart).estimate();
        along = exactDot(exactApart, exactTwice).estimate() / exactDenominator;
    }
    // From the nearer end, so that an intersection at an end is exactly that end.
    if (along <= 0.5) return (line.from - origin) + direction * std::max(along, 0.0);
    return (line.to - origin) - direction * std::max(1.0 - along, 0.0);
}

}  // namespace rubble
