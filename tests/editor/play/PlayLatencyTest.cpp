// Tests editor/play/PlayController.cpp.
#include "editor/play/PlayController.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/editor/Watchdog.h"

#include <QTest>
#include <QThread>

using namespace rubble;

namespace {

constexpr int kPatience = 60000;  // ms

QString textOf(const test::Watchdog& watchdog) {
    return QString("late by %1 ms, %2 ms of processor time, others late by %3 ms")
        .arg(watchdog.lateness())
        .arg(watchdog.processorTimeOfAHandler())
        .arg(watchdog.latenessOfControl());
}

}  // namespace

/// No event of the interface waits for the simulation.
class PlayLatencyTest : public QObject {
    Q_OBJECT
private slots:
    void watchdogSeesWaitsAndWork() {
        const test::Watchdog waiting;
        QTest::qWait(20);
        QTimer::singleShot(0, this, [] { QThread::msleep(2000); });
        QTRY_VERIFY2(waiting.lateness() > 1900.0, qPrintable(textOf(waiting)));
        QVERIFY2(waiting.processorTimeOfAHandler() < 500.0, qPrintable(textOf(waiting)));
        const test::Watchdog working;
        QTimer::singleShot(0, this, [] {
            const double start = test::Watchdog::processorTime();
            while (test::Watchdog::processorTime() < start + 100.0) continue;
        });
        QTRY_VERIFY2(!working.isInTime(), qPrintable(textOf(working)));
    }
    void seeksAndScriptsLetTheInterfaceRespond() {
        test::Stage stage(test::house());
        stage.controller.setToolSettings({});
        stage.start();
        for (int k = 0; k < 10; ++k) {
            stage.controller.throwAlong({{-6.0, 2.0 + 0.1 * k, 8.0}, {0.6, 0.0, -0.8}});
            stage.advance(60);
        }
        const std::uint64_t end = stage.step();
        const test::Watchdog watchdog;
        int scripts = 0;
        for (const std::uint64_t step : {std::uint64_t{0}, end, std::uint64_t{70}, end, std::uint64_t{1}, end}) {
            stage.controller.seek(step);
            stage.controller.requestScript([&](const PlayScript& script) { scripts += script.steps == end ? 1 : 0; });
            QTRY_COMPARE_WITH_TIMEOUT(stage.step(), step, kPatience);
        }
        QTRY_COMPARE_WITH_TIMEOUT(scripts, 6, kPatience);
        qInfo("%s", qPrintable(textOf(watchdog)));
        QVERIFY2(watchdog.isInTime(), qPrintable(textOf(watchdog)));
    }
};

RUBBLE_TEST_WITH(PlayLatencyTest, QCoreApplication)
#include "PlayLatencyTest.moc"
