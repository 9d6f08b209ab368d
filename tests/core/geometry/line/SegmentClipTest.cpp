#include "core/geometry/line/SegmentClip.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class SegmentClipTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsOutsideTheBoxIsCutOff() {
        const Box2 box{{-1.0, -1.0}, {2.0, 2.0}};
        const auto cut = clippedTo(box, {-5.0, 0.0}, {5.0, 0.0});
        QVERIFY(cut && isWithinDistance((*cut)[0], {-1.0, 0.0}, 1e-12) &&
                isWithinDistance((*cut)[1], {2.0, 0.0}, 1e-12));
        QVERIFY(!clippedTo(box, {-5.0, 3.0}, {5.0, 3.0}));
        QVERIFY(!clippedTo(box, {-5.0, 0.0}, {-2.0, 0.0}));
    }
};

RUBBLE_TEST(SegmentClipTest)
#include "SegmentClipTest.moc"
