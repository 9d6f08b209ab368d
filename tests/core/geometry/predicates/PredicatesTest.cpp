#include "core/geometry/predicates/Predicates.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/Expansion.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

__extension__ using Wide = __int128;

int signOf(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
Wide wide(double value) { return static_cast<Wide>(value); }

/// The determinants in 128-bit integers, exact for integer coordinates below 2^24.
int orientInIntegers(Vec2 a, Vec2 b, Vec2 c) {
    return signOf((wide(a.x) - wide(c.x)) * (wide(b.y) - wide(c.y)) -
                  (wide(a.y) - wide(c.y)) * (wide(b.x) - wide(c.x)));
}
int inCircleInIntegers(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Wide ax = wide(a.x) - wide(d.x), ay = wide(a.y) - wide(d.y);
    const Wide bx = wide(b.x) - wide(d.x), by = wide(b.y) - wide(d.y);
    const Wide cx = wide(c.x) - wide(d.x), cy = wide(c.y) - wide(d.y);
    return signOf((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
                  (cx * cx + cy * cy) * (ax * by - ay * bx));
}
int orient3dInIntegers(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Wide ax = wide(a.x) - wide(d.x), ay = wide(a.y) - wide(d.y), az = wide(a.z) - wide(d.z);
    const Wide bx = wide(b.x) - wide(d.x), by = wide(b.y) - wide(d.y), bz = wide(b.z) - wide(d.z);
    const Wide cx = wide(c.x) - wide(d.x), cy = wide(c.y) - wide(d.y), cz = wide(c.z) - wide(d.z);
    return signOf(az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx));
}

Vec2 latticePoint(Random& random, std::uint64_t size) {
    return {static_cast<double>(random.below(size)), static_cast<double>(random.below(size))};
}
Vec3 latticePoint3(Random& random, std::uint64_t size) {
    return {static_cast<double>(random.below(size)), static_cast<double>(random.below(size)),
            static_cast<double>(random.below(size))};
}

}  // namespace

class PredicatesTest : public QObject {
    Q_OBJECT
private slots:
    void signsMatchTheTextbook() {
        QCOMPARE(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
        QCOMPARE(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
        QCOMPARE(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
        QCOMPARE(inCircle({0, 0}, {1, 0}, {0, 1}, {0.9, 0.9}), 1);
        QCOMPARE(inCircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
        QCOMPARE(inCircle({0, 0}, {1, 0}, {0, 1}, {1.1, 1.1}), -1);
        QCOMPARE(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 1);
        QCOMPARE(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), -1);
        QCOMPARE(nearer({0.2, 5}, {0, 0}, {1, 0}), 1);
        QCOMPARE(nearer({0.8, 5}, {0, 0}, {1, 0}), -1);
        QCOMPARE(nearer({0.5, 5}, {0, 0}, {1, 0}), 0);
    }
    void oneUlpIsDetected() {
        const double above = std::nextafter(0.5, 1.0);
        QCOMPARE(orient2d({0, 0}, {1, 1}, {0.5, above}), 1);
        QCOMPARE(orient2d({12, 12}, {24, 24}, {0.5, 0.5}), 0);
        QCOMPARE(orient2d({12, 12}, {24, 24}, {0.5, above}), 1);
        QCOMPARE(nearer({1e6, 0.5}, {0, 0}, {0, std::nextafter(1.0, 2.0)}), 1);
        QCOMPARE(inCircle({1e6, 0}, {0, 1e6}, {-1e6, 0}, {0, std::nextafter(-1e6, 0.0)}), 1);
        QCOMPARE(inCircle({1e6, 0}, {0, 1e6}, {-1e6, 0}, {0, -1e6}), 0);
    }
    void latticeSignsMatchIntegers() {
        const std::uint64_t seed = 20;
        Random random(seed);
        for (int round = 0; round < 60000; ++round) {
            const std::uint64_t size = round % 3 == 0 ? 4 : round % 3 == 1 ? 100 : (1u << 24);
            const Vec2 a = latticePoint(random, size), b = latticePoint(random, size), c = latticePoint(random, size),
                       d = latticePoint(random, size);
            QVERIFY2(orient2d(a, b, c) == orientInIntegers(a, b, c), qPrintable(QString("seed %1").arg(seed)));
            QCOMPARE(inCircle(a, b, c, d), inCircleInIntegers(a, b, c, d));
            QCOMPARE(orient2dExact(a, b, c), orientInIntegers(a, b, c));
            QCOMPARE(inCircleExact(a, b, c, d), inCircleInIntegers(a, b, c, d));
            const Vec3 p = latticePoint3(random, size), q = latticePoint3(random, size),
                       r = latticePoint3(random, size), s = latticePoint3(random, size);
            QCOMPARE(orient3d(p, q, r, s), orient3dInIntegers(p, q, r, s));
        }
    }
    void predicatesAreExactAtTheEndsOfTheirRange() {
        const double tiny = kMinMagnitude, huge = kMaxMagnitude;
        QCOMPARE(inCircle({0, 0}, {tiny, 0}, {0, tiny}, {tiny, tiny}), 0);
        QCOMPARE(inCircle({0, 0}, {tiny, 0}, {0, tiny}, {tiny, std::nextafter(tiny, 0.0)}), 1);
        QCOMPARE(inCircle({0, 0}, {huge, 0}, {0, huge}, {huge, huge}), 0);
        QCOMPARE(inCircle({0, 0}, {huge, 0}, {0, huge}, {huge, std::nextafter(huge, 0.0)}), 1);
        QVERIFY(isExactlyUsable(0.0) && isExactlyUsable(tiny) && !isExactlyUsable(tiny / 2));
        QVERIFY(!isExactlyUsable(NAN) && !isExactlyUsable(INFINITY) && !isExactlyUsable(2 * huge));
    }
    void expansionsAreExact() {
        const auto value = exactDifference(1.0, 1e-30) * exactDifference(1.0, -1e-30);  // 1 - 1e-60
        QCOMPARE((value - exactly(1.0)).sign(), -1);
        QCOMPARE((value - value).sign(), 0);
        QCOMPARE(value.estimate(), 1.0);
        QCOMPARE((exactly(3.0) * exactly(5.0)).estimate(), 15.0);
    }
};

RUBBLE_TEST(PredicatesTest)
#include "PredicatesTest.moc"
