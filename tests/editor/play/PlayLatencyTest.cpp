// Tests editor/play/PlayController.cpp.
#include "editor/play/PlayController.h"

#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/editor/Watchdog.h"

#include <QSemaphore>
#include <QTest>

using namespace rubble;

namespace {

constexpr double kLongestHandler = 500.0;  // ms of processor time; usually a few, and a seek takes some seconds

QString textOf(const test::Watchdog& watchdog) {
    return QString("%1 ms of processor time").arg(watchdog.processorTimeOfAHandler());
}

}  // namespace

/// No event of the interface waits for the simulation.
class PlayLatencyTest : public QObject {
    Q_OBJECT
private slots:
    void watchdogSeesWork() {
        const test::Watchdog working;
        QTimer::singleShot(0, this, [] {
            const double start = test::processorTime();
            while (test::processorTime() < start + kLongestHandler) continue;
        });
        QTRY_VERIFY2(working.processorTimeOfAHandler() > kLongestHandler, qPrintable(textOf(working)));
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
            QSemaphore isReleased;  // holds up the simulation: what waits for it never ends
            stage.controller.thread().post([&isReleased](PlayEngine&) { isReleased.acquire(); });
            stage.controller.seek(step);
            stage.controller.requestScript([&](const PlayScript& script) { scripts += script.steps == end ? 1 : 0; });
            QCoreApplication::processEvents();
            isReleased.release();
            QTRY_COMPARE_WITH_TIMEOUT(stage.step(), step, kPatience);  // as it was recorded
            QTRY_VERIFY_WITH_TIMEOUT(!stage.controller.frame()->isRecorded, kPatience);
            QCOMPARE(stage.step(), step);
        }
        QTRY_COMPARE_WITH_TIMEOUT(scripts, 6, kPatience);
        qInfo("%s", qPrintable(textOf(watchdog)));
        QVERIFY2(watchdog.processorTimeOfAHandler() <= kLongestHandler, qPrintable(textOf(watchdog)));
    }
};

RUBBLE_TEST_WITH(PlayLatencyTest, QCoreApplication)
#include "PlayLatencyTest.moc"
