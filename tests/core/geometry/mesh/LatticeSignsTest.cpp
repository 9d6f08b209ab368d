// Tests core/geometry/mesh/LatticeSigns.cpp.
#include "core/geometry/mesh/LatticeSigns.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/WideInteger.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rubble;

namespace {

using Exact = WideInteger<4>;

Exact exact(double value) { return Exact(static_cast<std::int64_t>(value)); }

int exactAreaSign(Vec3 a, Vec3 b, Vec3 c, int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return (exact(b[i] - a[i]) * exact(c[j] - a[j]) - exact(b[j] - a[j]) * exact(c[i] - a[i])).sign();
}

/// By Sarrus' rule.
int sarrusSign(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    Exact sum(std::int64_t{0});
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum = sum + exact(b[k] - a[k]) * exact(c[i] - a[i]) * exact(d[j] - a[j]);
        sum = sum - exact(b[k] - a[k]) * exact(c[j] - a[j]) * exact(d[i] - a[i]);
    }
    return sum.sign();
}

/// Points on the lattice: anywhere, few places, or nearly in a plane through three others.
Vec3 randomPoint(Random& random, std::uint64_t size) {
    const double x = static_cast<double>(random.below(size)), y = static_cast<double>(random.below(size));
    return {x, y, static_cast<double>(random.below(size))};
}

}  // namespace

class LatticeSignsTest : public QObject {
    Q_OBJECT
private slots:
    void signsAreThoseOfTheViews() {
        QCOMPARE(areaSign({0, 0, 5}, {1, 0, 3}, {0, 1, 7}, 2), 1);
        QCOMPARE(areaSign({5, 0, 0}, {3, 1, 0}, {7, 0, 1}, 0), 1);
        QCOMPARE(areaSign({0, 5, 0}, {1, 3, 0}, {0, 7, 1}, 1), -1);
        QCOMPARE(volumeSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
        QCOMPARE(volumeSign({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}), -1);
        QVERIFY(areCollinear({1, 2, 3}, {2, 4, 6}, {4, 8, 12}));
        QVERIFY(!areCollinear({1, 2, 3}, {2, 4, 6}, {4, 8, 13}));
    }
    void signsAreExact() {
        Random random(1);
        int zeros = 0;
        for (int k = 0; k < 200'000; ++k) {
            const std::uint64_t size = k % 3 == 0   ? 4
                                       : k % 3 == 1 ? std::uint64_t{1} << 20
                                                    : (std::uint64_t{1} << 41) + 1;
            const Vec3 a = randomPoint(random, size), b = randomPoint(random, size), c = randomPoint(random, size);
            Vec3 d = randomPoint(random, size);
            if (k % 2 == 0) {  // nearly in the plane
                const double u = random.unit() / 2.0, v = random.unit() / 2.0;
                for (int i = 0; i < 3; ++i) d[i] = std::round(a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]));
            }
            QCOMPARE(volumeSign(a, b, c, d), sarrusSign(a, b, c, d));
            for (int axis = 0; axis < 3; ++axis) QCOMPARE(areaSign(a, b, c, axis), exactAreaSign(a, b, c, axis));
            zeros += volumeSign(a, b, c, d) == 0;
        }
        QVERIFY(zeros > 1000);
    }
    void largestNumbersFit() {
        const double most = 0x1p41;
        QCOMPARE(volumeSign({0, 0, 0}, {most, most, 0}, {most, 0, most}, {0, most, most}), -1);
        QCOMPARE(volumeSign({most, most, most}, {0, 0, most}, {0, most, 0}, {most, 0, 0}), 1);
        QCOMPARE(volumeSign({0, 0, 0}, {most, most, 1}, {most, most - 1, 1}, {most, most - 2, 1}), 0);
        QCOMPARE(volumeSign({0, 0, 0}, {most, most, 1}, {most, most - 1, 1}, {most - 1, most - 2, 1}), -1);
    }
    void anglesAreSorted() {
        const Vec3 p(10, 10, 3), q(10, 10, 7);
        std::vector<Vec3> points = {{9, 8, 5},  {11, 11, 0}, {10, 4, 5}, {12, 10, 9},
                                    {5, 10, 5}, {8, 11, 5},  {10, 12, 2}};
        const AngleAround angles(p, q, {11, 10, 5});
        std::ranges::sort(points, [&](Vec3 a, Vec3 b) { return angles.compare(a, b) < 0; });
        QCOMPARE(points, (std::vector<Vec3>{
                             {12, 10, 9}, {11, 11, 0}, {10, 12, 2}, {8, 11, 5}, {5, 10, 5}, {9, 8, 5}, {10, 4, 5}}));
        QCOMPARE(angles.compare({12, 11, 0}, {14, 12, 9}), 0);
        QCOMPARE(angles.compare({30, 10, 0}, {11, 10, 9}), 0);
        QCOMPARE(angles.compare({1, 10, 0}, {2, 10, 9}), 0);
        QVERIFY(angles.compare({12, 11, 0}, {14, 13, 9}) < 0);
    }
};

RUBBLE_TEST(LatticeSignsTest)
#include "LatticeSignsTest.moc"
