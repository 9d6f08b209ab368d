#include "editor/view3d/TimelineSpan.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class TimelineSpanTest : public QObject {
    Q_OBJECT
private slots:
    void wholeTimelineGrows() {
        TimelineSpan span;
        QCOMPARE(span.width(), 1.0);  // of an empty one
        span.setLength(600.0);
        QVERIFY(span.isWhole());
        QCOMPARE(span.last(), 600.0);
    }
    void zoomKeepsAStepInPlace() {
        TimelineSpan span;
        span.setLength(7080.0);
        span.zoom(3540.0, 4.0);
        QCOMPARE(span.width(), 1770.0);
        QCOMPARE(span.first(), 3540.0 - 885.0);
        span.zoom(2655.0 + 177.0, 2.0);  // at a tenth of the width
        QCOMPARE(span.width(), 885.0);
        QCOMPARE(span.first(), 2655.0 + 177.0 - 88.5);
        span.setLength(8000.0);
        QCOMPARE(span.width(), 885.0);
    }
    void zoomIsLimited() {
        TimelineSpan span;
        span.setLength(7080.0);
        span.zoom(100.0, 1e9);
        QCOMPARE(span.width(), TimelineSpan::kLeast);
        span.zoom(100.0, 1e-9);
        QVERIFY(span.isWhole());
        span.zoom(7080.0, 10.0);
        QCOMPARE(span.last(), 7080.0);
        span.pan(1e6);
        QCOMPARE(span.last(), 7080.0);
        span.pan(-1e6);
        QCOMPARE(span.first(), 0.0);
        span.setLength(300.0);  // another course that is shorter
        QVERIFY(span.isWhole());
    }
    void revealPansAsLittleAsNeeded() {
        TimelineSpan span;
        span.setLength(1000.0);
        span.zoom(0.0, 10.0);
        span.reveal(50.0);
        QCOMPARE(span.first(), 0.0);
        span.reveal(100.0);
        QCOMPARE(span.last(), 110.0);
        span.reveal(10.0);
        QCOMPARE(span.first(), 0.0);
    }
};

RUBBLE_TEST(TimelineSpanTest)
#include "TimelineSpanTest.moc"
