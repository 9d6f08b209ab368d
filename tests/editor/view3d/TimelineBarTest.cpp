#include "editor/view3d/TimelineBar.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QApplication>
#include <QHelpEvent>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

using namespace rubble;

namespace {

void turnWheel(QWidget& widget, double x, int notches, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF place(x, widget.height() / 2.0);
    QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

/// A timeline of 118 s, in which a block breaks after 50 s.
struct LongPlay {
    LongPlay() {
        bar.resize(1000, bar.sizeHint().height());
        stage.start();
        stage.playOn(3000);
        stage.controller.fire({.name = "shot", .action = test::throwAtBlock(3.0, 80.0)});
        stage.playOn(4080);
        broken = stage.controller.events().breaks().front()->record.step;
    }
    test::Stage stage;
    TimelineBar bar{stage.controller};
    std::uint64_t broken = 0;
};

}  // namespace

class TimelineBarTest : public QObject {
    Q_OBJECT
private slots:
    void twoSecondsOfTwoMinutesFillTheBar() {
        LongPlay play;
        const auto broken = static_cast<double>(play.broken);
        const double x = play.bar.positionOf(broken);
        QVERIFY(play.bar.positionOf(broken + 120.0) - x < 20.0);
        turnWheel(play.bar, x, 18);
        QVERIFY(std::abs(play.bar.positionOf(broken) - x) < 1.0);
        QVERIFY(play.bar.positionOf(broken + 120.0) - x > 500.0);
        QTest::mouseClick(&play.bar, Qt::LeftButton, {}, QPoint(static_cast<int>(x), play.bar.height() / 2));
        play.stage.settle();
        QVERIFY(play.stage.step() + 1 >= play.broken && play.stage.step() <= play.broken + 1);
        const double first = play.bar.span().first();
        turnWheel(play.bar, x, -1, Qt::ShiftModifier);
        QCOMPARE(play.bar.span().first(), first + 0.1 * play.bar.span().width());
        QTest::keyClick(&play.bar, Qt::Key_0);
        QVERIFY(play.bar.span().isWhole());
    }
    void keysZoomAtTheDisplayedTime() {
        LongPlay play;
        play.stage.controller.seek(1000);
        play.stage.settle();
        const double x = play.bar.positionOf(1000.0);
        for (int k = 0; k < 5; ++k) QTest::keyClick(&play.bar, Qt::Key_Plus);
        QVERIFY(play.bar.span().width() < 800.0);
        QVERIFY(std::abs(play.bar.positionOf(1000.0) - x) < 1.0);
        for (int k = 0; k < 5; ++k) QTest::keyClick(&play.bar, Qt::Key_Minus);
        QVERIFY(play.bar.span().isWhole());
    }
    void displayedTimeStaysVisible() {
        LongPlay play;
        play.stage.controller.seek(1000);
        play.stage.settle();
        for (int k = 0; k < 8; ++k) QTest::keyClick(&play.bar, Qt::Key_Plus);
        QTest::keyClick(&play.bar, Qt::Key_End);
        play.stage.settle();
        QVERIFY(play.bar.span().contains(7080.0));
        QTest::keyClick(&play.bar, Qt::Key_Left);
        QTest::keyClick(&play.bar, Qt::Key_Left, Qt::ShiftModifier);
        play.stage.settle();
        QCOMPARE(play.stage.step(), 7080u - 61u);
        QTest::keyClick(&play.bar, Qt::Key_Home);
        QTest::keyClick(&play.bar, Qt::Key_PageDown);
        play.stage.settle();
        QCOMPARE(play.stage.step(), play.stage.controller.shownEvents().front()->record.step);
        QTest::keyClick(&play.bar, Qt::Key_End);
        QTest::keyClick(&play.bar, Qt::Key_PageUp);
        play.stage.settle();
        QCOMPARE(play.stage.step(), play.stage.controller.shownEvents().back()->record.step);
    }
    void doubleClickOnABreakLoops() {
        LongPlay play;
        const double x = play.bar.positionOf(static_cast<double>(play.broken));
        QTest::mouseDClick(&play.bar, Qt::LeftButton, {}, QPoint(static_cast<int>(std::lround(x)), 10));
        play.stage.settle();
        QCOMPARE(play.stage.controller.frame()->loop.value(), loopAround(play.broken, test::Stage::kStep));
        QVERIFY(play.stage.controller.isPlaying());
        play.stage.controller.toggleLoop();
        play.stage.advance(1);
        QVERIFY(!play.stage.controller.frame()->loop);
        play.stage.controller.seek(0);
        play.stage.settle();
        play.stage.controller.toggleLoop();  // around the nearest one
        play.stage.settle();
        QCOMPARE(play.stage.controller.frame()->loop->last, play.broken + 60);
    }
    void toolTipsTellTheEventsAtThePointer() {
        LongPlay play;
        const int x = static_cast<int>(std::lround(play.bar.positionOf(static_cast<double>(play.broken))));
        QVERIFY2(toolTip(play.bar, x).contains("block broke into 5 fragment(s), hit by"),
                 qPrintable(toolTip(play.bar, x)));
        QVERIFY(!toolTip(play.bar, x - 100).contains("block"));
        EventFilter filter;
        filter.kinds.fill(false);
        play.stage.controller.setEventFilter(filter);  // governs the marks, too
        QVERIFY(!toolTip(play.bar, x).contains("block"));
        QTest::mouseDClick(&play.bar, Qt::LeftButton, {}, QPoint(x, 10));
        play.stage.settle();
        QVERIFY(!play.stage.controller.frame()->loop);
    }

private:
    static QString toolTip(TimelineBar& bar, int x) {
        QHelpEvent event(QEvent::ToolTip, {x, 10}, bar.mapToGlobal(QPoint(x, 10)));
        QApplication::sendEvent(&bar, &event);
        return QToolTip::text();
    }
};

RUBBLE_TEST_WITH(TimelineBarTest, QApplication)
#include "TimelineBarTest.moc"
