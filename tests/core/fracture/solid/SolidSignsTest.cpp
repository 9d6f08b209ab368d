// Tests core/fracture/solid/SolidSigns.cpp.
#include "core/fracture/solid/SolidSigns.h"

#include "core/base/Random.h"
#include "core/geometry/mesh/SolidLattice.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// Wide enough to compute with the weights as numbers.
using Huge = WideInteger<48>;
using HugeRow = std::array<Huge, 3>;

constexpr std::int64_t kSide = 5;  // of the grid, on which nearly everything ties

Huge power(int exponent) {
    Huge result;
    result.words[exponent / 64] = std::uint64_t{1} << (exponent % 64);
    return result;
}
/// The grid's step and the weight of a rank: far smaller than a step squared, far larger than that of the next rank.
const Huge kStep = power(200);
Huge weightOf(std::uint32_t rank) { return power(360 - 40 * static_cast<int>(rank)); }

Huge scaled(double coordinate) { return Huge(static_cast<std::int64_t>(coordinate)) * kStep; }

/// h_ij with weights.
Huge value(Vec3 x, const RankedSite& i, const RankedSite& j) {
    Huge sum = weightOf(j.rank) - weightOf(i.rank);
    for (int c = 0; c < 3; ++c) {
        const Huge toI = scaled(x[c] - i.point[c]), toJ = scaled(x[c] - j.point[c]);
        sum = sum + toI * toI - toJ * toJ;
    }
    return sum;
}
HugeRow row(const std::array<Vec3, 3>& corners, const RankedSite& i, const RankedSite& j) {
    return {value(corners[0], i, j), value(corners[1], i, j), value(corners[2], i, j)};
}
HugeRow crossed(const HugeRow& a, const HugeRow& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Huge dotted(const HugeRow& a, const HugeRow& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A place along the Voronoi edge of three sites as a fraction.
std::pair<Huge, Huge> placeOf(const std::array<Vec3, 3>& corners, const RankedSite& i, const RankedSite& j,
                              const RankedSite& k) {
    const auto offset = [&](Vec3 to) {
        return HugeRow{scaled(to.x - i.point.x), scaled(to.y - i.point.y), scaled(to.z - i.point.z)};
    };
    const HugeRow along = crossed(offset(j.point), offset(k.point));
    const HugeRow weights = crossed(row(corners, i, j), row(corners, i, k));
    Huge place, scale;
    for (int c = 0; c < 3; ++c) {
        place = place + weights[c] * dotted(offset(corners[c]), along);
        scale = scale + weights[c];
    }
    return {place, scale};
}

class Grid {
public:
    explicit Grid(std::uint64_t seed) : m_random(seed) {}
    Vec3 point() {
        const auto coordinate = [this] { return static_cast<double>(m_random.below(kSide)); };
        const double x = coordinate(), y = coordinate();
        return {x, y, coordinate()};
    }
    std::array<Vec3, 3> triangle() { return {point(), point(), point()}; }
    /// Distinct sites with ranks in random order.
    template <std::size_t Count>
    std::array<RankedSite, Count> sites() {
        std::array<RankedSite, Count> result;
        for (std::uint32_t k = 0; k < Count; ++k) result[k].rank = k;
        for (std::size_t k = Count; k > 1; --k) std::swap(result[k - 1].rank, result[m_random.below(k)].rank);
        for (std::size_t k = 0; k < Count; ++k) {
            do result[k].point = point();
            while (std::any_of(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(k),
                               [&](const RankedSite& other) { return other.point == result[k].point; }));
        }
        return result;
    }

private:
    Random m_random;
};

}  // namespace

/// Each sign against the same expression with weights that are numbers, on a grid of 5³ points.
class SolidSignsTest : public QObject {
    Q_OBJECT
private slots:
    void signsAtPointsAreThoseWithWeights() {
        Grid grid(1);
        for (int k = 0; k < 5'000; ++k) {
            const auto [i, l] = grid.sites<2>();
            const Vec3 x = grid.point();
            QCOMPARE(solid_signs::atPoint(x, i, l), value(x, i, l).sign());
        }
    }
    void signsAtEdgesAreThoseWithWeights() {
        Grid grid(2);
        int tested = 0, ties = 0;
        for (int k = 0; k < 20'000; ++k) {
            const auto [i, j, l] = grid.sites<3>();
            const Vec3 a = grid.point(), b = grid.point();
            const Huge ijA = value(a, i, j), ijB = value(b, i, j);
            if (ijA.sign() == ijB.sign()) continue;  // the bisector passes the edge by
            const Huge determinant = ijA * value(b, i, l) - ijB * value(a, i, l);
            QCOMPARE(solid_signs::edgeDeterminant(a, b, i, j, l), determinant.sign());
            ++tested;
            ties += solid_signs::bisectorValue(a, i.point, j.point).value == 0.0;
        }
        QVERIFY(tested > 1000 && ties > 100);
    }
    void signsInTrianglesAreThoseWithWeights() {
        Grid grid(3);
        int tested = 0;
        for (int n = 0; n < 20'000; ++n) {
            const auto [i, j, k, l] = grid.sites<4>();
            const std::array<Vec3, 3> corners = grid.triangle();
            const HugeRow weights = crossed(row(corners, i, j), row(corners, i, k));
            const bool isInside = weights[0].sign() == weights[1].sign() && weights[1].sign() == weights[2].sign();
            if (!isInside || weights[0].sign() == 0) continue;  // the Voronoi edge passes the triangle by
            QCOMPARE(solid_signs::triangleDeterminant(corners, i, j, k, l), dotted(weights, row(corners, i, l)).sign());
            ++tested;
        }
        QVERIFY(tested > 1000);
    }
    void orderAlongEdgesIsThatWithWeights() {
        Grid grid(4);
        int tested = 0, equal = 0;
        for (int n = 0; n < 400'000 && tested < 600; ++n) {
            const auto [i, j, k] = grid.sites<3>();
            const std::array<Vec3, 3> a = grid.triangle(), b = grid.triangle();
            bool isHit = true;
            for (const auto& corners : {a, b}) {
                const HugeRow weights = crossed(row(corners, i, j), row(corners, i, k));
                const int sign = weights[0].sign();
                isHit = isHit && sign != 0 && weights[1].sign() == sign && weights[2].sign() == sign;
            }
            if (!isHit) continue;
            const auto [placeA, scaleA] = placeOf(a, i, j, k);
            const auto [placeB, scaleB] = placeOf(b, i, j, k);
            const int order = (placeA * scaleB - placeB * scaleA).sign() * scaleA.sign() * scaleB.sign();
            QCOMPARE(solid_signs::orderAlongEdge(a, scaleA.sign() > 0, b, scaleB.sign() > 0, i, j, k), order);
            ++tested;
            equal += order == 0;
        }
        QVERIFY(tested >= 500);
    }
    void spheresAreThoseOfWeightedSites() {
        Grid grid(5);
        int tested = 0;
        for (int n = 0; n < 20'000; ++n) {
            auto [a, b, c, d, p] = grid.sites<5>();
            const int turn = orient3d(a.point, b.point, c.point, d.point);
            if (turn == 0) continue;
            if (turn < 0) std::swap(a, b);
            // The determinant of the sites lifted by |x - p|² less their weights.
            std::array<HugeRow, 4> rows;
            std::array<Huge, 4> lifts;
            const std::array<RankedSite, 4> corners = {a, b, c, d};
            for (int k = 0; k < 4; ++k) {
                const Vec3 offset = corners[k].point - p.point;
                rows[k] = {scaled(offset.x), scaled(offset.y), scaled(offset.z)};
                lifts[k] = dotted(rows[k], rows[k]) - weightOf(corners[k].rank) + weightOf(p.rank);
            }
            Huge sum;
            for (int k = 0; k < 4; ++k) {
                const Huge minor = dotted(crossed(rows[(k + 1) & 3], rows[(k + 2) & 3]), rows[(k + 3) & 3]) * lifts[k];
                sum = k % 2 == 0 ? sum - minor : sum + minor;
            }
            QCOMPARE(solid_signs::inSphere(a, b, c, d, p), sum.sign());
            ++tested;
        }
        QVERIFY(tested > 10'000);
    }
    void largestCoordinatesDoNotOverflow() {
        // The sphere through far sites, as far out as a triangulation has them, and the points of the lattice's box.
        const double far = 4.5 * kLatticeSteps;
        RankedSite a{{far, far, far}, 10}, b{{far, -far, -far}, 11}, c{{-far, far, -far}, 12}, d{{-far, -far, far}, 13};
        if (orient3d(a.point, b.point, c.point, d.point) < 0) std::swap(a, b);
        QCOMPARE(solid_signs::inSphere(a, b, c, d, {{0, 0, 0}, 0}), 1);
        QCOMPARE(solid_signs::inSphere(a, b, c, d, {{-far, -far, -far}, 0}), 1);  // on it: the lowest rank is inside
        // With the highest rank, that of (far, far, far) decides, from whose face it is on the other side.
        QCOMPARE(solid_signs::inSphere(a, b, c, d, {{-far, -far, -far}, 20}), 1);
        QCOMPARE(solid_signs::inSphere(a, b, c, d, {{-far, -far, -far - 1.0}, 0}), -1);
    }
};

RUBBLE_TEST(SolidSignsTest)
#include "SolidSignsTest.moc"
