#include "editor/play/PlayEngine.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/play/MortarPortal.h"

#include <QSignalSpy>

using namespace rubble;

/// More of it is tested through its controller: see PlayControllerTest.
class PlayEngineTest : public QObject {
    Q_OBJECT
private slots:
    void mortarThatHoldsNothingIsReported_data() {
        QTest::addColumn<bool>("isAnchored");
        QTest::newRow("anchored") << true;
        QTest::newRow("not anchored") << false;
    }
    void mortarThatHoldsNothingIsReported() {
        QFETCH(const bool, isAnchored);
        Project project = test::mortarPortal();
        if (!isAnchored) {
            for (Instance& instance : project.instances) instance.isAnchored = false;
        }
        test::Stage stage(project);
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.start();
        stage.advance(1);
        QCOMPARE(messages.size(), isAnchored ? 0 : 1);
        if (!isAnchored) QVERIFY(messages[0][0].toString().contains("joints"));
    }
    void instanceAtTheRayIsRemoved() {
        test::Stage stage;
        stage.start();
        stage.advance(1);
        const int before = stage.controller.frame()->statistics.bodies;
        stage.controller.removeAlong(RemovalExtent::Body, test::kAtBlock);
        stage.advance(2);
        QCOMPARE(stage.controller.frame()->statistics.bodies, before - 1);
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.controller.removeAlong(RemovalExtent::Body, test::kAtBlock);
        stage.advance(2);
        QCOMPARE(messages.size(), 1);
        QVERIFY(messages[0][0].toString().startsWith("Nothing was removed"));
        stage.controller.reset();
        stage.advance(1);
        QCOMPARE(stage.controller.frame()->statistics.bodies, before);
    }
    /// Ten minutes of the clock take no step and no frame, and a throw goes on at once.
    void nothingIsPlayedWhileEverythingRests() {
        test::Stage stage;
        stage.start();
        stage.advance(600);
        const std::uint64_t rested = stage.step();
        QVERIFY2(rested >= 90 && rested < 120, qPrintable(QString::number(rested)));
        QVERIFY(stage.controller.isPlaying());
        QVERIFY(stage.controller.frame()->isAtRest);
        QSignalSpy updates(&stage.controller.thread(), &PlayThread::updateReady);
        QSignalSpy frames(&stage.controller, &PlayController::frameChanged);
        stage.controller.thread().advance(600.0);
        QCoreApplication::processEvents();
        QCOMPARE(updates.size(), 0);
        QCOMPARE(frames.size(), 0);
        stage.controller.setToolSettings(test::heavyBox());
        stage.controller.throwAlong(test::kAtBlock);
        stage.settle();
        stage.advance(30);
        QCOMPARE(stage.step(), rested + 30);
        QVERIFY(!stage.controller.frame()->isAtRest);
        QVERIFY(stage.controller.frame()->length == rested + 30);
    }
    void whatIsAimedIsShownWhileEverythingRests() {
        test::Stage stage;
        stage.start();
        stage.advance(200);
        stage.controller.aim(test::kAtBlock);
        stage.settle();
        QVERIFY(stage.controller.frame()->aimed.has_value());
        QVERIFY(stage.controller.frame()->isAtRest);
    }
    void stepsThatAreKnownAreDisplayed() {
        test::Stage stage;
        stage.start();
        stage.advance(200);
        const std::uint64_t length = stage.controller.frame()->length;
        stage.controller.seek(0);
        stage.settle();
        stage.controller.play();
        stage.advance(static_cast<int>(length) / 2);
        QCOMPARE(stage.step(), length / 2);
    }
};

RUBBLE_TEST_WITH(PlayEngineTest, QCoreApplication)
#include "PlayEngineTest.moc"
