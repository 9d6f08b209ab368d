#include "editor/play/PlayController.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/House.h"
#include "tests/support/PlayStage.h"

#include <QElapsedTimer>
#include <QSignalSpy>

using namespace rubble;

namespace {

constexpr double kStep = test::Stage::kStep;

const Ray kAtBlock{{0.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};

PlayTools heavyBox() {
    PlayTools tools;
    tools.thrown = {.size = Vec3(0.2), .mass = 3.0, .speed = 80.0};
    return tools;
}

}  // namespace

class PlayControllerTest : public QObject {
    Q_OBJECT
private slots:
    void playsAtThePaceOfTheClock() {
        test::Stage stage;
        QCOMPARE(stage.controller.state(), PlayState::Stopped);
        stage.start();
        QCOMPARE(stage.step(), 0u);
        stage.advance(10);
        QCOMPARE(stage.step(), 10u);
        stage.controller.thread().advance(0.4 * kStep);
        QVERIFY(std::abs(stage.controller.share() - 0.4) < 1e-6);
        stage.controller.setTimeScale(0.5);
        stage.advance(10);
        QCOMPARE(stage.step(), 15u);
        stage.controller.setTimeScale(2.0);
        stage.advance(10);
        QCOMPARE(stage.step(), 35u);
    }
    void slowScenesDoNotJump() {
        test::Stage stage;
        stage.start();
        stage.controller.thread().advance(1.0);  // as if the last step had taken that long
        stage.controller.takeNews();
        QCOMPARE(stage.step(), 2u);  // the one that was due, and the next at once
        stage.advance(1);
        QCOMPARE(stage.step(), 3u);
    }
    void pausesStepsAndGoesOn() {
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
    void aThrowIsSeenWithinTwoFrames() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        const std::size_t before = visibleBodies(stage);
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(1);
        QCOMPARE(visibleBodies(stage), before + 1);
        QVERIFY(stage.controller.lastShot().has_value());
    }
    void tellsWhatBroke() {
        test::Stage stage;
        stage.controller.setTools(heavyBox());
        stage.start();
        const QSignalSpy told(&stage.controller, &PlayController::breaksChanged);
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(20);
        QVERIFY(!told.isEmpty());
        QCOMPARE(stage.controller.breaks().size(), 1u);
        const ToldBreak& broken = stage.controller.breaks().front();
        QCOMPARE(broken.name, "block");
        QCOMPARE(broken.threshold, 100.0);
        QVERIFY(broken.ratio() > 1.0 && broken.pieces == 5);
        QCOMPARE(stage.controller.costs().size(), 20u);
    }
    void withoutDestructionNothingBreaks() {
        test::Stage stage;
        stage.controller.setTools(heavyBox());
        stage.start();
        stage.controller.setDestruction(false);
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(30);
        QCOMPARE(stage.controller.breaks().size(), 0u);
        QVERIFY(stage.controller.frame()->figures.cost.step == 30);
    }
    void whatIsThrownBeforeAllIsBakedIsThrownAsSoonAsItBegins() {
        test::Stage stage;
        Asset asset = stage.document.project().assets[0];
        asset.prism.depth = 0.3;
        stage.document.push(altered("Make it thinner", asset));
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
        QCOMPARE(stage.controller.breaks().size(), 1u);
        QCOMPARE(stage.controller.script().inputs.front().step, 0u);
    }
    void whatWasThrownBeforeAResetIsNot() {
        test::Stage stage;
        Asset asset = stage.document.project().assets[0];
        asset.prism.depth = 0.3;
        stage.document.push(altered("Make it thinner", asset));
        stage.controller.play();
        stage.controller.fire({.name = "given up", .action = test::throwAtBlock(3.0, 80.0)});
        stage.controller.reset();
        stage.bake();
        stage.settle();
        stage.advance(2);
        QVERIFY(!stage.controller.lastShot());
    }
    void theSwitchSaysWhetherThingsBreakAtTheMomentThatIsShown() {
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
    void aReplayWithoutDestructionSetsTheSwitch() {
        test::Stage stage;
        const QSignalSpy told(&stage.controller, &PlayController::rulesChanged);
        stage.controller.replay({.settings = {.hasDestruction = false}, .steps = 10});
        stage.settle();
        QVERIFY(!stage.controller.hasDestruction());
        QCOMPARE(told.size(), 1);
        stage.controller.setDestruction(true);
        stage.controller.fire({.name = "box", .action = test::throwAtBlock(3.0, 80.0)});
        stage.advance(20);
        QVERIFY(stage.controller.hasDestruction());
        QCOMPARE(stage.controller.breaks().size(), 1u);
        stage.controller.replay({.settings = {.hasDestruction = false}, .steps = 10});
        stage.settle();
        stage.controller.reset();  // as the switch says
        stage.settle();
        stage.controller.fire({.name = "box", .action = test::throwAtBlock(3.0, 80.0)});
        stage.advance(20);
        QCOMPARE(stage.controller.breaks().size(), 0u);
    }
    void goesBackAndPlaysAnotherWay() {
        test::Stage stage;
        stage.controller.setTools(heavyBox());
        stage.start();
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(40);
        const ContentHash broken = stage.hash();
        stage.controller.seek(0);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        QCOMPARE(stage.controller.frame()->length, 40u);
        QCOMPARE(stage.controller.breaks().size(), 1u);  // still to come
        stage.controller.seek(40);
        stage.settle();
        QCOMPARE(stage.hash(), broken);
        QCOMPARE(stage.controller.breaks().size(), 1u);  // told once
        stage.controller.seek(0);
        stage.settle();
        stage.controller.strikeAlong({{0.0, 9.0, 0.0}, {1.0, 0.0, 0.0}});  // meets nothing
        stage.settle();
        QCOMPARE(stage.controller.frame()->length, 40u);
        stage.controller.throwAlong({kAtBlock.from, {0.0, 1.0, 0.0}}, 1.0);
        stage.settle();
        QCOMPARE(stage.controller.frame()->length, 0u);
        QCOMPARE(stage.controller.breaks().size(), 0u);
    }
    void aSeekWhileThePlayIsPreparedLetsItBegin() {
        test::Stage stage;
        QSignalSpy said(&stage.controller, &PlayController::said);
        stage.controller.play();
        stage.controller.seek(7);
        stage.controller.thread().seek(7);  // as one that was under way does
        stage.settle();
        QCOMPARE(said.size(), 0);
        QVERIFY(stage.controller.isPlaying());
        QCOMPARE(stage.step(), 0u);
    }
    void withoutAPlayThereIsNoScript() {
        test::Stage stage;
        QVERIFY(stage.controller.script().inputs.empty());
        stage.controller.play();  // the play is not there yet: nobody would answer
        QVERIFY(stage.controller.script().inputs.empty());
    }
    void aThresholdIsFollowedAtOnceAndCanBeUndone() {
        test::Stage stage;
        stage.controller.setTools(heavyBox());
        stage.start();
        stage.advance(5);
        Asset asset = stage.document.project().assets[0];
        asset.threshold = 1e6;
        stage.document.push(altered("Change threshold", asset));
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(20);
        QVERIFY(stage.step() >= 25u);
        QCOMPARE(stage.controller.breaks().size(), 0u);
        stage.document.undoStack().undo();
        stage.controller.throwAlong(kAtBlock, 1.0);
        stage.advance(40);
        QVERIFY(!stage.controller.breaks().empty());
    }
    void anotherPlaceBeginsAnewAsSoonAsItIsBaked() {
        test::Stage stage;
        stage.start();
        stage.advance(5);
        Instance instance = stage.document.project().instances[0];
        instance.pose.position.x = 2.0;
        stage.document.push(altered("Move", instance));
        QCOMPARE(stage.controller.state(), PlayState::Preparing);
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Playing);
        QCOMPARE(stage.step(), 0u);
        Asset asset = stage.document.project().assets[0];
        asset.prism.depth = 0.3;
        stage.controller.pause();
        stage.document.push(altered("Make it thinner", asset));
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Preparing);
        stage.bake();
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Paused);
    }
    void theHouseBeginsAnewInAMoment() {
        test::Stage stage(test::house());
        stage.start();
        stage.advance(3);
        QElapsedTimer timer;
        timer.start();
        Instance instance = stage.document.project().instances[0];
        instance.pose.position.z += 3.0;
        stage.document.push(altered("Move", instance));
        stage.settle();
        QCOMPARE(stage.controller.state(), PlayState::Playing);
        qInfo("begun anew in %.2f ms", static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    void whatCannotBePlayedIsSaid() {
        Project project = test::floatingBlock();
        test::Stage stage(project);
        const Id asset = project.assets[0].id;
        stage.bakes.set(asset, std::make_shared<const BakedAsset>(
                                   BakedAsset{std::make_shared<const Asset>(project.assets[0]), nullptr,
                                              Error{ErrorCode::BadInput, "It cannot be cut."}}));
        QSignalSpy said(&stage.controller, &PlayController::said);
        stage.controller.play();
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(stage.controller.state(), PlayState::Stopped);
        QVERIFY2(said[0][0].toString().contains("block"), qPrintable(said[0][0].toString()));
    }
    void aRecordedScriptPlaysAgain() {
        test::Stage stage;
        stage.controller.setTools(heavyBox());
        stage.start();
        stage.advance(3);
        stage.controller.throwAlong(kAtBlock, 0.9);
        stage.advance(30);
        const ContentHash hash = stage.hash();
        const PlayScript script = stage.controller.script();
        QCOMPARE(script.inputs.size(), 1u);
        QCOMPARE(script.steps, 33u);
        stage.controller.replay(script);
        stage.settle();
        QCOMPARE(stage.step(), 0u);
        stage.advance(33);
        QCOMPARE(stage.hash(), hash);
        QCOMPARE(stage.controller.breaks().size(), 1u);
    }
    void whatIsGrabbedFollowsTheRay() {
        test::Stage stage;
        stage.start();
        stage.controller.grabAlong(kAtBlock);
        stage.advance(1);
        QVERIFY(stage.controller.frame()->isHolding);
        stage.controller.dragAlong({kAtBlock.from + Vec3(1.0, 0.0, 0.0), kAtBlock.direction});
        stage.advance(90);
        QVERIFY(heightlessPlace(stage).x > 0.8);
        stage.controller.letGo();
        stage.advance(1);
        QVERIFY(!stage.controller.frame()->isHolding);
    }
    void aimingShowsTheFlight() {
        test::Stage stage;
        stage.start();
        stage.controller.pause();
        stage.controller.aim(kAtBlock, 0.5);
        stage.settle();
        const std::optional<Flight>& flight = stage.controller.frame()->flight;
        QVERIFY(flight && flight->hit);
        QVERIFY(std::abs(flight->hit->point.z - 0.25) < 1e-4);
        stage.controller.aim(std::nullopt);
        stage.settle();
        QVERIFY(!stage.controller.frame()->flight);
    }

private:
    static std::size_t visibleBodies(test::Stage& stage) {
        const RenderScene& scene = *stage.controller.frame()->scene;
        return static_cast<std::size_t>(
            std::ranges::count_if(scene.looks, [](const BodyLook& look) { return (look.marks & kHidden) == 0; }));
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

QTEST_GUILESS_MAIN(PlayControllerTest)
#include "PlayControllerTest.moc"
