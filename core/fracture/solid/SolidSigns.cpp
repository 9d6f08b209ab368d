#include "core/fracture/solid/SolidSigns.h"

#include <algorithm>

namespace rubble::solid_signs {
namespace {

// Widths in bits, for coordinates of 41 bits and a sign: differences 41, values of h 85, their 2x2 determinants 172,
// 3x3 determinants 259; along a Voronoi edge 478. In the sphere, with coordinates of 43 bits: 227.
using Wide4 = WideInteger<4>;
using Wide5 = WideInteger<5>;
using Wide8 = WideInteger<8>;

std::int64_t integer(double coordinate) { return static_cast<std::int64_t>(coordinate); }

template <class Number>
Number det2(const Number& a, const Number& b, const Number& c, const Number& d) {
    return a * d - b * c;
}

template <class Number>
using Row = std::array<Number, 3>;

template <class Number>
Row<Number> crossed(const Row<Number>& a, const Row<Number>& b) {
    return {det2(a[1], a[2], b[1], b[2]), det2(a[2], a[0], b[2], b[0]), det2(a[0], a[1], b[0], b[1])};
}

template <class Number>
Number dotted(const Row<Number>& a, const Row<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Number sumOf(const Row<Number>& a) {
    return a[0] + a[1] + a[2];
}

/// A coefficient of a weight in a sum that is otherwise zero.
struct Term {
    std::uint32_t rank;
    int sign;
};

/// The sign of a sum of weights: that of the first coefficient, by rank, that is not zero.
template <std::size_t Count>
int signOfWeights(std::array<Term, Count> terms) {
    std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.rank < b.rank; });
    for (const Term& term : terms) {
        if (term.sign != 0) return term.sign;
    }
    return 0;
}

template <int Words>
Row<WideInteger<Words>> exactRow(const std::array<Vec3, 3>& corners, Vec3 i, Vec3 j) {
    return {exactBisectorValue(corners[0], i, j), exactBisectorValue(corners[1], i, j),
            exactBisectorValue(corners[2], i, j)};
}

Row<BoundedDouble> row(const std::array<Vec3, 3>& corners, Vec3 i, Vec3 j) {
    return {bisectorValue(corners[0], i, j), bisectorValue(corners[1], i, j), bisectorValue(corners[2], i, j)};
}

template <class Number>
Number inSphereDeterminant(const std::array<Row<Number>, 4>& rows) {
    Number sum = Number(std::int64_t{0});
    for (int k = 0; k < 4; ++k) {
        const Row<Number>&u = rows[(k + 1) & 3], &v = rows[(k + 2) & 3], &w = rows[(k + 3) & 3];
        const Number minor = dotted(crossed(u, v), w) * dotted(rows[k], rows[k]);
        sum = k % 2 == 0 ? sum - minor : sum + minor;
    }
    return sum;
}

/// The sign of inSphereDeterminant(), where it is large for the extents of its rows; else 0. The determinant has 4
/// terms of a square length and a minor, which has 6 products of three coordinates; each of these 24 products is
/// rounded 12 times at most. Coordinates are exact.
int clearInSphereSign(const std::array<Vec3, 4>& offsets) {
    const auto& [a, b, c, d] = offsets;
    const auto flat = [](const Vec3& u, const Vec3& v) { return u.x * v.y - v.x * u.y; };
    const double ab = flat(a, b), bc = flat(b, c), cd = flat(c, d), da = flat(d, a), ac = flat(a, c), bd = flat(b, d);
    const double abc = a.z * bc - b.z * ac + c.z * ab, bcd = b.z * cd - c.z * bd + d.z * bc;
    const double cda = c.z * da + d.z * ac + a.z * cd, dab = d.z * ab + a.z * bd + b.z * da;
    const auto square = [](const Vec3& u) { return u.x * u.x + u.y * u.y + u.z * u.z; };
    const double aa = square(a), bb = square(b), cc = square(c), dd = square(d);
    const double sum = (dd * abc - cc * dab) + (bb * cda - aa * bcd);
    const auto largest = [&](auto coordinate) {
        return std::max(std::max(std::abs(coordinate(a)), std::abs(coordinate(b))),
                        std::max(std::abs(coordinate(c)), std::abs(coordinate(d))));
    };
    const double reach = largest([](const Vec3& u) { return u.x; }) * largest([](const Vec3& u) { return u.y; }) *
                         largest([](const Vec3& u) { return u.z; });
    const double bound = 512.0 * kRounding * reach * std::max(std::max(aa, bb), std::max(cc, dd));
    return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

int tieInSphere(const RankedSite& a, const RankedSite& b, const RankedSite& c, const RankedSite& d,
                const RankedSite& p) {
    // p is below the lifted plane, that is inside, if its own weight comes first; a corner's weight lowers the plane at
    // p where its barycentric coordinate is positive.
    return signOfWeights<5>({{{p.rank, 1},
                              {a.rank, -orient3d(p.point, b.point, c.point, d.point)},
                              {b.rank, -orient3d(a.point, p.point, c.point, d.point)},
                              {c.rank, -orient3d(a.point, b.point, p.point, d.point)},
                              {d.rank, -orient3d(a.point, b.point, c.point, p.point)}}});
}

/// N and S of the point at which a triangle meets a Voronoi edge: its place along the edge is N / S.
struct PlaceOnEdge {
    Wide8 place, scale;
    Wide8 ofJ, ofK;  // the coefficients of w_j - w_i and of w_k - w_i in `place`
};

PlaceOnEdge placeOnEdge(const std::array<Vec3, 3>& corners, Vec3 i, Vec3 j, Vec3 k) {
    const Row<Wide8> one = {std::int64_t{1}, std::int64_t{1}, std::int64_t{1}};
    const auto offset = [&](Vec3 to) {
        return Row<Wide8>{integer(to.x - i.x), integer(to.y - i.y), integer(to.z - i.z)};
    };
    const Row<Wide8> along = crossed(offset(j), offset(k));
    const Row<Wide8> places = {dotted(offset(corners[0]), along), dotted(offset(corners[1]), along),
                               dotted(offset(corners[2]), along)};
    const Row<Wide8> ij = exactRow<8>(corners, i, j), ik = exactRow<8>(corners, i, k);
    const Row<Wide8> weights = crossed(ij, ik);
    return {dotted(weights, places), sumOf(weights), dotted(crossed(one, ik), places),
            dotted(crossed(ij, one), places)};
}

}  // namespace

Int128 exactBisectorValue(Vec3 x, Vec3 i, Vec3 j) {
    const Vec3 apart = j - i, twice = 2.0 * x - i - j;
    return Int128{integer(apart.x)} * integer(twice.x) + Int128{integer(apart.y)} * integer(twice.y) +
           Int128{integer(apart.z)} * integer(twice.z);
}

int inSphere(const RankedSite& a, const RankedSite& b, const RankedSite& c, const RankedSite& d, const RankedSite& p) {
    const std::array<Vec3, 4> offsets = {a.point - p.point, b.point - p.point, c.point - p.point, d.point - p.point};
    if (const int sign = clearInSphereSign(offsets); sign != 0) return sign;
    std::array<Row<BoundedDouble>, 4> rows;
    for (int k = 0; k < 4; ++k) rows[k] = {offsets[k].x, offsets[k].y, offsets[k].z};
    if (const int sign = inSphereDeterminant(rows).sign(); sign != 0) return sign;
    std::array<Row<Wide4>, 4> exact;
    for (int k = 0; k < 4; ++k) exact[k] = {integer(offsets[k].x), integer(offsets[k].y), integer(offsets[k].z)};
    if (const int sign = inSphereDeterminant(exact).sign(); sign != 0) return sign;
    return tieInSphere(a, b, c, d, p);
}

int atPoint(Vec3 x, const RankedSite& i, const RankedSite& l) {
    if (const int sign = bisectorValue(x, i.point, l.point).sign(); sign != 0) return sign;
    const Int128 exact = exactBisectorValue(x, i.point, l.point);
    if (exact != 0) return exact > 0 ? 1 : -1;
    return i.rank < l.rank ? -1 : 1;
}

int edgeDeterminant(Vec3 a, Vec3 b, const RankedSite& i, const RankedSite& j, const RankedSite& l) {
    const BoundedDouble filtered = det2(bisectorValue(a, i.point, j.point), bisectorValue(b, i.point, j.point),
                                        bisectorValue(a, i.point, l.point), bisectorValue(b, i.point, l.point));
    if (filtered.sign() != 0) return filtered.sign();
    const Wide4 ijA = exactBisectorValue(a, i.point, j.point), ijB = exactBisectorValue(b, i.point, j.point);
    const Wide4 ilA = exactBisectorValue(a, i.point, l.point), ilB = exactBisectorValue(b, i.point, l.point);
    if (const int sign = det2(ijA, ijB, ilA, ilB).sign(); sign != 0) return sign;
    const Wide4 ofJ = ilB - ilA, ofL = ijA - ijB;
    return signOfWeights<3>({{{j.rank, ofJ.sign()}, {l.rank, ofL.sign()}, {i.rank, (-(ofJ + ofL)).sign()}}});
}

int triangleDeterminant(const std::array<Vec3, 3>& corners, const RankedSite& i, const RankedSite& j,
                        const RankedSite& k, const RankedSite& l) {
    const BoundedDouble filtered =
        dotted(crossed(row(corners, i.point, j.point), row(corners, i.point, k.point)), row(corners, i.point, l.point));
    if (filtered.sign() != 0) return filtered.sign();
    const Row<Wide5> ij = exactRow<5>(corners, i.point, j.point), ik = exactRow<5>(corners, i.point, k.point),
                     il = exactRow<5>(corners, i.point, l.point);
    if (const int sign = dotted(crossed(ij, ik), il).sign(); sign != 0) return sign;
    const Wide5 ofJ = sumOf(crossed(ik, il)), ofK = sumOf(crossed(il, ij)), ofL = sumOf(crossed(ij, ik));
    return signOfWeights<4>(
        {{{j.rank, ofJ.sign()}, {k.rank, ofK.sign()}, {l.rank, ofL.sign()}, {i.rank, (-(ofJ + ofK + ofL)).sign()}}});
}

int orderAlongEdge(const std::array<Vec3, 3>& a, bool leavesA, const std::array<Vec3, 3>& b, bool leavesB,
                   const RankedSite& i, const RankedSite& j, const RankedSite& k) {
    const PlaceOnEdge first = placeOnEdge(a, i.point, j.point, k.point);
    const PlaceOnEdge second = placeOnEdge(b, i.point, j.point, k.point);
    const int scales = leavesA == leavesB ? 1 : -1;  // the sign of the product of both scales
    if (const int sign = det2(first.place, first.scale, second.place, second.scale).sign(); sign != 0) {
        return scales * sign;
    }
    const Wide8 ofJ = det2(first.ofJ, first.scale, second.ofJ, second.scale);
    const Wide8 ofK = det2(first.ofK, first.scale, second.ofK, second.scale);
    return scales * signOfWeights<3>({{{j.rank, ofJ.sign()}, {k.rank, ofK.sign()}, {i.rank, (-(ofJ + ofK)).sign()}}});
}

}  // namespace rubble::solid_signs
