#include "core/geometry/polygon/BoundaryDistance.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <numbers>

using namespace rubble;

namespace {

Ring starAtEqualAngles(Random& random, int corners, double size) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        ring.push_back(size * random.between(0.5, 1.0) * Vec2(cosine(angle), sine(angle)));
    }
    return ring;
}

double bruteForce(const Polygon& polygon, Vec2 point) {
    double nearest = 1e308;
    std::vector<Ring> rings = polygon.holes;
    rings.push_back(polygon.outer);
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            nearest = std::min(nearest, distanceToSegment(point, ring[i], ring[(i + 1) % ring.size()]));
    return nearest;
}

}  // namespace

class BoundaryDistanceTest : public QObject {
    Q_OBJECT
private slots:
    void distanceIsThatOfBruteForce() {
        const std::uint64_t seed = 12;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (const int corners : {3, 4, 30, 500}) {
            const Polygon polygon{starAtEqualAngles(random, corners, 1.0), {starAtEqualAngles(random, 5, 0.3)}};
            const BoundaryDistance boundary(polygon);
            for (int query = 0; query < 300; ++query) {
                const Vec2 point(random.between(-1.2, 1.2), random.between(-1.2, 1.2));
                QCOMPARE(boundary.of(point), bruteForce(polygon, point));
            }
            QCOMPARE(boundary.of(polygon.outer[1]), 0.0);
        }
    }
    void distanceOfTheCentreOfASquareIsHalfItsSide() {
        const BoundaryDistance boundary({{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}});
        QCOMPARE(boundary.of({1.0, 1.0}), 1.0);
        QCOMPARE(boundary.largestOf(std::vector<Ring>{{{1.0, 1.0}, {3.0, 1.0}, {5.0, 1.0}}}), 3.0);
    }
    void distanceBetweenIsTheLargerOfBothDirections() {
        const Polygon small{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}};
        const Polygon wide{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}}, {}};
        QCOMPARE(distanceBetween(small, wide), 2.0);
        QCOMPARE(distanceBetween(wide, small), 2.0);
        QCOMPARE(distanceBetween(wide, wide), 0.0);
    }
};

RUBBLE_TEST(BoundaryDistanceTest)
#include "BoundaryDistanceTest.moc"
