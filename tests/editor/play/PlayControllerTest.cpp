#include "editor/play/PlayController.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/RestingProjects.h"

#include <QElapsedTimer>
#include <QSignalSpy>

using namespace rubble;

namespace {

constexpr double kStep = test::Stage::kStep;

}  // namespace

class PlayControllerTest : public QObject {
    Q_OBJECT
private slots:
    void stepsFollowTheClock() {
        test::Stage stage;
        QCOMPARE(stage.controller.state(), PlayState::Stopped);
        stage.start();
        QCOMPARE(stage.step(), 0u);
        stage.advance(10);
        QCOMPARE(stage.step(), 10u);
        stage.controller.thread().advance(0.4 * kStep);
        QVERIFY(std::abs(stage.controller.stepFraction() - 0.4) < 1e-6);
        stage.controller.setTimeScale(0.5);
        stage.advance(10);
        QCOMPARE(stage.step(), 15u);
        stage.controller.setTimeScale(2.0);
        stage.advance(10);
        QCOMPARE(stage.step(), 35u);
    }
    void slowStepsAreNotCaughtUp() {
        test::Stage stage;
        stage.start();
        stage.controller.thread().advance(1.0);  // as if the last step had been slow
        stage.controller.applyUpdate();
        QCOMPARE(stage.step(), 2u);  // the one that was due and one more
        stage.advance(1);
        QCOMPARE(stage.step(), 3u);
    }
    void pausesStepsAndResumes() {
        test::Stage stage;
        stage.start();
        stage.advance(3);
        stage.controller.pause();
        stage.advance(5);
        QCOMPARE(stage.step(), 3u);
        stage.controller.stepOnce();
        stage.settle();
        QCOMPARE(stage.step(), 4u);
        QCOMPARE(stage.controller.state(), PlayState::Paused);
        stage.controller.play();
        stage.advance(2);
        QVERIFY(stage.step() >= 5u);
        stage.controller.stop();
        QVERIFY(!stage.controller.frame());
        QCOMPARE(stage.document.project(), test::floatingBlock());
    }
    void throwIsVisibleWithinTwoFrames() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        const std::size_t before = visibleBodies(stage);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(1);
        QCOMPARE(visibleBodies(stage), before + 1);
        QVERIFY(stage.controller.lastShot().has_value());
    }
    void reportsBreaks() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        const QSignalSpy reported(&stage.controller, &PlayController::eventsChanged);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(20);
        QVERIFY(!reported.isEmpty());
        QCOMPARE(stage.controller.events().breaks().size(), 1u);
        const PlayEvent& broken = *stage.controller.events().breaks().front();
        QCOMPARE(broken.name, "block");
        QCOMPARE(broken.strength->threshold, 100.0);
        QVERIFY(broken.strength->ratio() > 1.0 && broken.record.count == 5);
        QCOMPARE(stage.controller.costs().size(), 20u);
    }
    void nothingBreaksWithDestructionOff() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.setDestruction(false);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(30);
        QCOMPARE(stage.controller.events().breaks().size(), 0u);
        QVERIFY(stage.controller.frame()->statistics.cost.step == 30);
    }
    void throwsAreQueuedUntilAssetsAreBaked() {
        test::Stage stage;
        Asset asset = stage.document.project().assets[0];
        asset.prism().depth = 0.3;
        stage.document.push(modify("Make it thinner", asset));
        stage.controller.play();
        stage.controller.fire({.name = "kept", .action = test::throwAtBlock(3.0, 80.0)});
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Preparing);
        stage.bake();
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Playing);
        stage.advance(1);
        QCOMPARE(stage.controller.lastShot().value().name, std::string("kept"));
        stage.advance(20);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);
        QCOMPARE(stage.script().inputs.front().step, 0u);
    }
    void resetDiscardsQueuedThrows() {
        test::Stage stage;
        Asset asset = stage.document.project().assets[0];
        asset.prism().depth = 0.3;
        stage.document.push(modify("Make it thinner", asset));
        stage.controller.play();
        stage.controller.fire({.name = "given up", .action = test::throwAtBlock(3.0, 80.0)});
        stage.controller.reset();
        stage.bake();
        stage.settle();
        stage.advance(2);
        QVERIFY(!stage.controller.lastShot());
    }
    void destructionSwitchFollowsTheDisplayedStep() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        stage.controller.pause();
        stage.controller.setDestruction(false);
        stage.settle();
        QVERIFY(!stage.controller.hasDestruction());
        stage.controller.play();
        stage.advance(5);
        QVERIFY(!stage.controller.hasDestruction());
        stage.controller.seek(3);
        stage.settle();
        QVERIFY(stage.controller.hasDestruction());
        stage.controller.seek(8);
        stage.settle();
        QVERIFY(!stage.controller.hasDestruction());
    }
    void replayWithoutDestructionSetsTheSwitch() {
        test::Stage stage;
        const QSignalSpy reported(&stage.controller, &PlayController::settingsChanged);
        stage.controller.replay({.settings = {.hasDestruction = false}, .steps = 10});
        stage.settle();
        QVERIFY(!stage.controller.hasDestruction());
        QCOMPARE(reported.size(), 1);
        stage.controller.setDestruction(true);
        stage.controller.fire({.name = "box", .action = test::throwAtBlock(3.0, 80.0)});
        stage.advance(20);
        QVERIFY(stage.controller.hasDestruction());
        QCOMPARE(stage.controller.events().breaks().size(), 1u);
        stage.controller.replay({.settings = {.hasDestruction = false}, .steps = 10});
        stage.settle();
        stage.controller.reset();  // uses the switch
        stage.settle();
        stage.controller.fire({.name = "box", .action = test::throwAtBlock(3.0, 80.0)});
        stage.advance(20);
        QCOMPARE(stage.controller.events().breaks().size(), 0u);
    }
    void inputAfterSeekingBackDiscardsTheFuture() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(40);
        const ContentHash broken = stage.hash();
        stage.controller.seek(0);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        QCOMPARE(stage.controller.frame()->length, 40u);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);  // kept for seeking forward
        stage.controller.seek(40);
        stage.settle();
        QCOMPARE(stage.hash(), broken);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);  // recorded once
        stage.controller.seek(0);
        stage.settle();
        stage.controller.hammerAlong({{0.0, 9.0, 0.0}, {1.0, 0.0, 0.0}});  // misses
        stage.settle();
        QCOMPARE(stage.controller.frame()->length, 40u);
        stage.controller.throwAlong({test::kAtBlock.from, {0.0, 1.0, 0.0}});
        stage.settle();
        QCOMPARE(stage.controller.frame()->length, 0u);
        QCOMPARE(stage.controller.events().breaks().size(), 0u);
    }
    void seekWhilePreparingIsIgnored() {
        test::Stage stage;
        QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.controller.play();
        stage.controller.seek(7);
        stage.controller.thread().seek(7);  // as with a queued seek
        stage.settle();
        QCOMPARE(messages.size(), 0);
        QVERIFY(stage.controller.isPlaying());
        QCOMPARE(stage.step(), 0u);
    }
    void failureOfAnEarlierStartIsIgnored() {
        test::Stage stage;
        stage.start();
        emit stage.controller.thread().failed("The earlier start failed.");
        QVERIFY(stage.controller.isPlaying());
    }
    void noScriptWithoutSession() {
        test::Stage stage;
        QVERIFY(stage.script().inputs.empty());
        stage.controller.play();  // still preparing: there is no engine to answer
        QVERIFY(stage.script().inputs.empty());
    }
    void thresholdEditsApplyLiveAndCanBeUndone() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.advance(5);
        Asset asset = stage.document.project().assets[0];
        asset.threshold = 1e6;
        stage.document.push(modify("Change threshold", asset));
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(20);
        QVERIFY(stage.step() >= 25u);
        QCOMPARE(stage.controller.events().breaks().size(), 0u);
        stage.document.undoStack().undo();
        const Ray besideTheFirst{test::kAtBlock.from + Vec3(0.3, 0.0, 0.0), test::kAtBlock.direction};
        stage.controller.throwAlong(besideTheFirst);
        stage.advance(40);
        QVERIFY(!stage.controller.events().breaks().empty());
    }
    void geometryEditsRestartOnceBaked() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        Instance instance = stage.document.project().instances[0];
        instance.pose.position.x = 2.0;
        stage.document.push(modify("Move", instance));
        QCOMPARE(stage.controller.state(), PlayState::Preparing);
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Playing);
        QCOMPARE(stage.step(), 0u);
        Asset asset = stage.document.project().assets[0];
        asset.prism().depth = 0.3;
        stage.controller.pause();
        stage.document.push(modify("Make it thinner", asset));
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Preparing);
        stage.bake();
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Paused);
    }
    void houseRestartsQuickly() {
        test::Stage stage(test::house());
        stage.start();
        stage.advance(3);
        QElapsedTimer timer;
        timer.start();
        Instance instance = stage.document.project().instances[0];
        instance.pose.position.z += 3.0;
        stage.document.push(modify("Move", instance));
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Playing);
        qInfo("begun anew in %.2f ms", static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    void reportsWhatCannotBePlayed() {
        Project project = test::floatingBlock();
        test::Stage stage(project);
        const Id asset = project.assets[0].id;
        stage.bakes.set(asset, std::make_shared<const BakedAsset>(
                                   BakedAsset{std::make_shared<const Asset>(project.assets[0]), nullptr,
                                              Error{ErrorCode::BadInput, "It cannot be cut."}}));
        QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.controller.play();
        QTRY_COMPARE(messages.size(), 1);
        QCOMPARE(stage.controller.state(), PlayState::Stopped);
        QVERIFY2(messages[0][0].toString().contains("block"), qPrintable(messages[0][0].toString()));
    }
    void replaysARecordedScript() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.advance(3);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(30);
        const ContentHash hash = stage.hash();
        const PlayScript script = stage.script();
        QCOMPARE(script.inputs.size(), 1u);
        QCOMPARE(script.steps, 33u);
        stage.controller.replay(script);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        stage.advance(33);
        QCOMPARE(stage.hash(), hash);
        QCOMPARE(stage.controller.events().breaks().size(), 1u);
    }
    void grabbedBodyFollowsTheRay() {
        test::Stage stage;
        stage.start();
        stage.controller.grabAlong(test::kAtBlock);
        stage.advance(1);
        QVERIFY(stage.controller.frame()->grabbed);
        QVERIFY(!stage.controller.frame()->grabbed->isTooHeavy());
        stage.controller.dragAlong({test::kAtBlock.from + Vec3(1.0, 0.0, 0.0), test::kAtBlock.direction});
        stage.advance(90);
        QVERIFY(heightlessPlace(stage).x > 0.8);
        const GrabbedBody grabbed = *stage.controller.frame()->grabbed;
        QVERIFY(glm::distance(grabbed.point, grabbed.target) < 0.05);
        stage.controller.release();
        stage.advance(1);
        QVERIFY(!stage.controller.frame()->grabbed);
    }
    void grabOfAHeavyBodySaysThatItIsTooHeavy() {
        Project project = test::floatingBlock();
        project.gravity = Vec3(0.0, -9.81, 0.0);
        test::Stage stage(project);
        PlayToolSettings tools;
        tools.grabForce = 1.0;
        stage.controller.setToolSettings(tools);
        stage.start();
        stage.controller.grabAlong(test::kAtBlock);
        stage.advance(1);
        const GrabbedBody grabbed = *stage.controller.frame()->grabbed;
        QVERIFY(grabbed.isTooHeavy());
        QCOMPARE(grabbed.force, 1.0);
        QVERIFY(std::abs(grabbed.weight - 9.81 * grabbed.mass) < 1e-6 * grabbed.weight);
    }
    void grabOfNothingOrAFixedBodySaysWhy() {
        test::Stage stage;
        QStringList messages;
        connect(&stage.controller, &PlayController::statusMessage, this,
                [&](const QString& text) { messages << text; });
        stage.start();
        stage.controller.grabAlong({test::kAtBlock.from, {0.0, 1.0, 0.0}});
        stage.advance(1);
        QCOMPARE(messages, QStringList{"Nothing was grabbed: there is no body at the pointer."});
        messages.clear();
        stage.controller.grabAlong({{50.0, 5.0, 50.0}, {0.0, -1.0, 0.0}});  // the ground
        stage.advance(1);
        QCOMPARE(messages, QStringList{"Nothing was grabbed: the body at the pointer is fixed."});
        QVERIFY(!stage.controller.frame()->grabbed);
    }
    void holdingThrowsFaster() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        for (const double charge : {0.0, 0.5, 1.0}) {
            stage.controller.throwAlong(test::kAtBlock, charge);
            stage.advance(1);
            const Throw& thrown = std::get<Throw>(stage.controller.lastShot()->action);
            QCOMPARE(thrown.speed, 80.0 * (1.0 + 1.5 * charge));
        }
    }
    void impactsThatBreakNothingAreListed() {
        Project project = test::floatingBlock();
        project.assets[0].threshold = 600.0;
        test::Stage stage(project);
        stage.controller.setToolSettings(test::heavyBox());  // 240 N·s
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(20);
        QVERIFY(stage.controller.events().breaks().empty());
        QCOMPARE(stage.controller.shownEvents().size(), 1u);
        const PlayEvent& impact = *stage.controller.shownEvents().front();
        QVERIFY(!impact.isBreak() && impact.name == "block");
        QVERIFY(impact.strength->ratio() > 0.38 && impact.strength->ratio() < 0.41);
    }
    void breaksAreCountedUpToAStep() {
        test::Stage stage;
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(20);
        const std::uint64_t step = stage.controller.events().breaks().front()->record.step;
        QCOMPARE(stage.controller.events().breaks(step - 1).size(), 0u);
        QCOMPARE(stage.controller.events().breaks(step).size(), 1u);
    }
    void replaysPauseAtTheirEndAndResume() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.controller.replay(stage.script());
        stage.settle();
        stage.advance(9);
        QCOMPARE(stage.step(), 5u);
        QCOMPARE(stage.controller.state(), PlayState::Paused);
        QCOMPARE(messages.size(), 1);
        stage.controller.play();
        stage.advance(2);
        QVERIFY(stage.step() > 5u);
    }
    void restartingEditsSaySo() {
        test::Stage stage;
        stage.start();
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        Instance moved = stage.document.project().instances[0];
        moved.pose.position.x += 1.0;
        stage.document.push(modify("Move it", moved));
        QCOMPARE(messages.size(), 1);
        QVERIFY(messages[0][0].toString().contains("restarts"));
    }
    void restartForgetsTheAim() {
        test::Stage stage;
        stage.start();
        stage.controller.aim(test::kAtBlock);
        stage.advance(1);
        QVERIFY(stage.controller.frame()->trajectory);
        stage.controller.reset();
        QVERIFY(!stage.controller.frame()->trajectory && !stage.controller.frame()->aimed);
        stage.settle();
        QVERIFY(!stage.controller.frame()->trajectory);
    }
    void whatWouldFallFollowsThePointer() {
        Project project = test::stackProject();
        test::Stage stage(project);
        stage.start();
        stage.advance(30);
        const auto collapseAt = [&](double height) {
            stage.controller.aim(Ray{{0.0, height, 4.0}, {0.0, 0.0, -1.0}});
            stage.advance(1);
            return stage.controller.frame()->collapse;
        };
        QVERIFY(!collapseAt(0.25));
        stage.controller.setOverlays({.hasCollapse = true});
        const auto lowest = collapseAt(0.25);
        QVERIFY(lowest && lowest->bodies == 4 && std::abs(lowest->mass - 2000.0) < 0.1);
        QVERIFY(lowest->first > 0.2 && lowest->last > lowest->first && lowest->last < 0.7);
        QCOMPARE(collapseAt(1.75)->bodies, std::size_t{1});
        QCOMPARE(collapseAt(2.25)->bodies, std::size_t{0});
        QVERIFY(!collapseAt(9.0));  // nothing is there
        stage.controller.pause();
        stage.settle();
        stage.controller.aim(Ray{{0.0, 1.25, 4.0}, {0.0, 0.0, -1.0}});
        stage.settle();
        QCOMPARE(stage.controller.frame()->collapse->bodies, std::size_t{2});
        stage.controller.setOverlays({});
        stage.settle();
        QVERIFY(!stage.controller.frame()->collapse);
    }
    void whatWouldFallTakesAwayTheFragmentAtThePointer() {
        Project project = test::bondedPortal(1.5, 0.0);
        test::Stage stage(project);
        stage.start();
        stage.controller.setOverlays({.hasCollapse = true});
        const auto collapseAt = [&](double height) {
            stage.controller.aim(Ray{{-1.75, height, 4.0}, {0.0, 0.0, -1.0}});
            stage.advance(1);
            return stage.controller.frame()->collapse;
        };
        const auto foot = collapseAt(0.1), top = collapseAt(2.45);
        QVERIFY(foot && foot->name.starts_with("wall/") && foot->bodies > 5 && foot->mass > 100.0);
        QVERIFY(top && top->name.starts_with("wall/") && top->name != foot->name);
        QVERIFY(top->bodies < foot->bodies);
    }
    void aimingShowsTheTrajectory() {
        test::Stage stage;
        stage.start();
        stage.controller.pause();
        stage.controller.aim(test::kAtBlock, 0.5);
        stage.settle();
        const std::optional<Trajectory>& flight = stage.controller.frame()->trajectory;
        QVERIFY(flight && flight->hit);
        QVERIFY(std::abs(flight->hit->point.z - 0.25) < 1e-4);
        stage.controller.aim(std::nullopt);
        stage.settle();
        QVERIFY(!stage.controller.frame()->trajectory);
    }

private:
    static std::size_t visibleBodies(test::Stage& stage) {
        const RenderScene& scene = *stage.controller.frame()->scene;
        return static_cast<std::size_t>(std::ranges::count_if(
            scene.appearances, [](const BodyAppearance& look) { return (look.marks & kHidden) == 0; }));
    }
    static Vec3 heightlessPlace(test::Stage& stage) {
        Vec3 place(0.0);
        stage.controller.thread().post([&](PlayEngine& engine) {
            for (const PlayBody& body : engine.session().bodies()) {
                if (body.role == PlayRole::Instance) place = engine.session().world().state(body.body).pose.position;
            }
        });
        stage.controller.thread().settle();
        return place;
    }
};

RUBBLE_TEST_WITH(PlayControllerTest, QCoreApplication)
#include "PlayControllerTest.moc"
