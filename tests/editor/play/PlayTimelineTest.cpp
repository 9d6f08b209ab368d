// Tests editor/play/PlayController.cpp and editor/play/PlayEngine.cpp.
#include "editor/play/PlayController.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"

#include <QSemaphore>
#include <QSignalSpy>

#include <set>

using namespace rubble;

/// Going back, loops and branches.
class PlayTimelineTest : public QObject {
    Q_OBJECT
private slots:
    void stepsBackAndForth() {
        test::Stage stage;
        stage.start();
        stage.advance(40);
        for (int k = 0; k < 3; ++k) stage.controller.stepBack();  // before the first is carried out
        stage.settle();
        QCOMPARE(stage.step(), 37u);
        QCOMPARE(stage.controller.state(), PlayState::Paused);
        stage.controller.stepBack();
        stage.controller.stepOnce();
        stage.controller.stepOnce();
        stage.settle();
        QCOMPARE(stage.step(), 38u);
        stage.controller.seekBy(-1000);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        stage.controller.seekBy(1000);
        stage.settle();
        QCOMPARE(stage.step(), 40u);
        stage.controller.stepOnce();
        stage.settle();
        QCOMPARE(stage.step(), 41u);
    }
    void restartKeepsEarlierTimelines() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(40);
        const ContentHash broken = stage.hash();
        stage.controller.reset();
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        QCOMPARE(stage.controller.frame()->branches.size(), std::size_t{1});
        QVERIFY(stage.controller.events().breaks().empty());
        stage.advance(40);
        QVERIFY(stage.hash() != broken);  // nothing was thrown
        stage.controller.switchTo(stage.controller.frame()->branches[0].id);
        stage.settle();
        stage.controller.seek(40);
        stage.settle();
        QCOMPARE(stage.hash(), broken);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);
    }
    void loopsAroundABreak() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.advance(50);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(250);
        const std::uint64_t broken = stage.controller.events().breaks().front()->record.step;
        stage.controller.loopAround(broken);
        stage.settle();
        QCOMPARE(stage.step(), broken - 30);
        QVERIFY(stage.controller.isPlaying());
        QCOMPARE(stage.controller.frame()->loop.value(), (PlayLoop{broken - 30, broken + 60}));
        stage.advance(90);
        QCOMPARE(stage.step(), broken + 60);
        stage.advance(1);
        QCOMPARE(stage.step(), broken - 30);
        stage.advance(91 + 5);
        QCOMPARE(stage.step(), broken - 25);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);  // each time the same one
        QCOMPARE(stage.controller.events().breaks(stage.step()).size(), 0u);
        stage.controller.endLoop();
        stage.advance(120);
        QCOMPARE(stage.step(), broken + 95);
        QVERIFY(!stage.controller.frame()->loop);
    }
    void loopOfAReplayEndsWithIt() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(30);
        stage.controller.replay(stage.script());
        stage.settle();
        stage.controller.loopAround(10);
        stage.settle();
        stage.advance(31);
        QVERIFY(stage.controller.isPlaying());
        QCOMPARE(stage.step(), 0u);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(100);
        QVERIFY(!stage.controller.frame()->loop);  // the throw ended it
        QCOMPARE(stage.step(), 100u);
    }
    void anotherTimeStepRestarts() {
        test::Stage stage;
        stage.start();
        stage.advance(10);
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.controller.setTimeStep(1.0 / 120.0);
        QCOMPARE(messages.size(), 1);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        QCOMPARE(stage.controller.thread().stepLength(), 1.0 / 120.0);
        for (int k = 0; k < 10; ++k) stage.controller.thread().advance(1.0 / 120.0);
        stage.controller.applyUpdate();
        QCOMPARE(stage.step(), 10u);
        QCOMPARE(stage.script().settings.dt, 1.0 / 120.0);
        stage.controller.setTimeStep(0.2);  // out of range
        QCOMPARE(stage.controller.timeStep(), 1.0 / 120.0);
    }
    /// The seek is as long as it takes: nobody waits for it but the script.
    void scriptDoesNotWaitForASeek() {
        test::Stage stage(test::house());
        stage.start();
        stage.playOn(600);
        stage.controller.seek(0);
        stage.settle();
        QSemaphore isReleased;  // holds up the simulation, as a long seek does
        stage.controller.thread().post([&isReleased](PlayEngine&) { isReleased.acquire(); });
        stage.controller.seek(600);
        std::optional<PlayScript> received;
        stage.controller.requestScript([&](PlayScript script) { received = std::move(script); });
        const bool isWaiting = !received;
        isReleased.release();
        QVERIFY(isWaiting);
        stage.controller.thread().settle();
        QCoreApplication::sendPostedEvents(&stage.controller);
        QCOMPARE(received.value().steps, 600u);
        stage.controller.requestScript([](const PlayScript&) { QFAIL("The session has ended."); });
        stage.controller.stop();
        stage.controller.thread().settle();
        QCoreApplication::sendPostedEvents(&stage.controller);
    }
    void eventsAreSoughtOneByOne() {
        test::Stage stage;
        stage.controller.nextEvent();  // there is no session
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.advance(10);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(40);
        std::set<std::uint64_t> steps;
        for (const EventRef& event : stage.controller.shownEvents()) steps.insert(event->record.step);
        QVERIFY(!steps.empty());
        stage.controller.nextEvent();  // there is none
        stage.settle();
        QCOMPARE(stage.step(), 50u);
        stage.controller.seek(0);
        for (const std::uint64_t step : steps) {
            stage.controller.nextEvent();
            stage.settle();
            QCOMPARE(stage.step(), step);
        }
        for (auto step = std::next(steps.rbegin()); step != steps.rend(); ++step) {
            stage.controller.previousEvent();
            stage.settle();
            QCOMPARE(stage.step(), *step);
        }
        stage.controller.previousEvent();
        stage.settle();
        QCOMPARE(stage.step(), *steps.begin());
        EventFilter filter;
        filter.kinds.fill(false);
        stage.controller.setEventFilter(filter);
        stage.controller.nextEvent();
        stage.settle();
        QCOMPARE(stage.step(), *steps.begin());
    }
    void dustIsTheSamePlayedAndSought() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        std::vector<std::vector<Particle>> played;
        for (int step = 1; step <= 30; ++step) {
            stage.advance(1);
            played.push_back(stage.controller.frame()->scene->particles);
        }
        QVERIFY(played.back().size() > 5);
        for (const std::uint64_t step : {12u, 30u, 25u, 1u, 29u}) {
            stage.controller.seek(step);
            stage.settle();
            QVERIFY(stage.controller.frame()->scene->particles == played[step - 1]);
        }
    }
    void throwInThePastKeepsABranch() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.advance(10);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(40);
        const ContentHash hash = stage.hash();
        const std::vector<EventRef> events = stage.controller.shownEvents();
        QVERIFY(stage.controller.frame()->branches.empty());
        stage.controller.seek(5);
        stage.settle();
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        PlayToolSettings light = test::heavyBox();
        light.projectile.mass = 0.1;
        stage.controller.setToolSettings(light);
        stage.controller.throwAlong(test::kAtBlock);
        stage.controller.play();
        stage.advance(60);
        QCOMPARE(messages.size(), 1);
        QCOMPARE(stage.controller.events().breaks().size(), 0u);
        const std::vector<PlayBranch> branches = stage.controller.frame()->branches;
        QCOMPARE(branches.size(), 1u);
        QCOMPARE(branches[0],
                 (PlayBranch{.id = branches[0].id, .fork = 5, .length = 50, .broken = {.breaks = 1, .fragments = 5}}));

        stage.controller.switchTo(branches[0].id);
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Paused);
        QCOMPARE(stage.step(), 5u);
        QCOMPARE(stage.controller.frame()->length, 50u);
        QCOMPARE(stage.controller.frame()->branches[0].length, 65u);
        QCOMPARE(stage.controller.shownEvents(), events);
        stage.controller.seek(50);
        stage.settle();
        QCOMPARE(stage.hash(), hash);
        QCOMPARE(stage.controller.shownEvents(), events);  // not recorded twice
    }
};

RUBBLE_TEST_WITH(PlayTimelineTest, QCoreApplication)
#include "PlayTimelineTest.moc"
