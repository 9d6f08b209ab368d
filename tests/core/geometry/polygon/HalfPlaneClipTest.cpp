#include "core/geometry/polygon/HalfPlaneClip.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class HalfPlaneClipTest : public QObject {
    Q_OBJECT
private slots:
    void halvesASquare() {
        Ring clipped;
        clipByHalfPlane(unitSquare().outer, {{1.0, 0.0}, 0.5}, clipped);
        QCOMPARE(clipped, (Ring{{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}}));
    }
    void keepsAllOrNothing() {
        Ring clipped;
        clipByHalfPlane(unitSquare().outer, {{1.0, 0.0}, 2.0}, clipped);
        QCOMPARE(clipped, unitSquare().outer);
        clipByHalfPlane(unitSquare().outer, {{1.0, 0.0}, -1.0}, clipped);
        QVERIFY(clipped.empty());
        clipByHalfPlane({}, {{1.0, 0.0}, 2.0}, clipped);
        QVERIFY(clipped.empty());
    }
    void cornersOnBoundaryAreKept() {
        Ring clipped;
        clipByHalfPlane(unitSquare().outer, {{1.0, 1.0}, 1.0}, clipped);
        QCOMPARE(clipped, (Ring{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}));
    }
    void touchingTheBoundaryGivesNothing() {
        Ring clipped{{7.0, 7.0}};
        clipByHalfPlane(unitSquare().outer, {{1.0, 0.0}, 0.0}, clipped);  // one edge
        QVERIFY(clipped.empty());
        clipByHalfPlane(unitSquare().outer, {{1.0, 1.0}, 0.0}, clipped);  // one corner
        QVERIFY(clipped.empty());
    }
    void bothSidesAddUpToTheWhole() {
        Random random(11);
        for (int round = 0; round < 100; ++round) {
            const Vec2 a(random.unit(), random.unit()), b(random.unit(), random.unit());
            Ring left, right;
            clipByHalfPlane(unitSquare().outer, nearerTo(a, b), left);
            clipByHalfPlane(unitSquare().outer, nearerTo(b, a), right);
            QVERIFY(std::abs(signedArea(left) + signedArea(right) - 1.0) < 1e-14);  // a few roundings of 1
        }
    }
    void neighboursOfAnEdgeGetTheSameCorner() {
        const Ring lower = rectangle({0.0, 0.0}, {0.3, 0.7}), upper = rectangle({0.0, 0.7}, {0.3, 1.0});
        Ring lowerPart, upperPart;
        const HalfPlane halfPlane = nearerTo({0.1, 0.6}, {0.3, 0.9});
        clipByHalfPlane(lower, halfPlane, lowerPart);
        clipByHalfPlane(upper, halfPlane, upperPart);
        int shared = 0;
        for (const Vec2 corner : lowerPart)
            shared += static_cast<int>(std::count(upperPart.begin(), upperPart.end(), corner));
        QCOMPARE(shared, 2);
    }
    void nearerToIsThePerpendicularBisector() {
        const HalfPlane halfPlane = nearerTo({1.0, 1.0}, {3.0, 1.0});
        QCOMPARE(halfPlane.normal, Vec2(2.0, 0.0));
        QCOMPARE(halfPlane.offset, 4.0);  // x <= 2
    }
};

RUBBLE_TEST(HalfPlaneClipTest)
#include "HalfPlaneClipTest.moc"
