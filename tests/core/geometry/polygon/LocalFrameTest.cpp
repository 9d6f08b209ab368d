#include "core/geometry/polygon/LocalFrame.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class LocalFrameTest : public QObject {
    Q_OBJECT
private slots:
    void outlineNearTheOriginKeepsIt() {
        const LocalFrame frame = localFrame({rectangle({-1.0, 0.5}, {3.0, 2.0}), {}});
        QCOMPARE(frame.origin, Vec2(0.0, 0.0));
        QCOMPARE(frame.extent, 3.0);
        QVERIFY(frame.weldDistance == 3.0 * 0x1p-46);  // QCOMPARE takes both for zero
    }
    void farOutlineHasItsFirstCornerAsOriginOnTheFarAxisOnly() {
        const LocalFrame frame = localFrame({rectangle({1e6, 0.5}, {1e6 + 4.0, 2.0}), {}});
        QCOMPARE(frame.origin, Vec2(1e6, 0.0));
        QCOMPARE(frame.extent, 4.0);
        QCOMPARE(localFrame({rectangle({-10.0, 0.0}, {-8.0, 1.0}), {}}).origin, Vec2(-10.0, 0.0));
    }
    void pointsWithinTheWeldDistanceCoincide() {
        const LocalFrame frame{.extent = 1.0, .weldDistance = 0.25};
        QVERIFY(frame.coincide({1.0, 1.0}, {1.25, 0.75}));
        QVERIFY(!frame.coincide({1.0, 1.0}, {1.26, 1.0}));
        QVERIFY(!frame.coincide({1.0, 1.0}, {1.0, 0.74}));
    }
};

RUBBLE_TEST(LocalFrameTest)
#include "LocalFrameTest.moc"
