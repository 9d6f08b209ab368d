// Tests editor/play/RecordedFrames.cpp and editor/play/PlayThread.cpp.
#include "editor/play/RecordedFrames.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QSemaphore>

using namespace rubble;

namespace {

/// A stage whose block was broken at step 11, played up to step 40.
struct BrokenStage : test::Stage {
    BrokenStage() {
        controller.setToolSettings(test::heavyBox());
        start();
        advance(10);
        controller.throwAlong(test::kAtBlock);
        advance(30);
    }
    /// The frames of steps as the session gives them.
    PlayFrame soughtFrame(std::uint64_t step) {
        controller.seek(step);
        settle();
        return *controller.frame();
    }
};

/// Holds up the simulation, as a long step does, until it is destroyed.
class HeldUp {
public:
    explicit HeldUp(test::Stage& stage) {
        stage.controller.thread().post([this](PlayEngine&) {
            m_isHeld.release();
            m_isReleased.acquire();
        });
        m_isHeld.acquire();
    }
    ~HeldUp() { m_isReleased.release(); }

private:
    QSemaphore m_isHeld, m_isReleased;
};

QString differenceOf(const PlayFrame& recorded, const PlayFrame& sought) {
    RenderScene a = *recorded.scene, b = *sought.scene;
    if (*a.restOffsets != *b.restOffsets) return "other finishes";
    for (RenderScene* scene : {&a, &b}) {
        scene->previousPoses.clear();
        scene->summary.reset();
        scene->restOffsets.reset();
    }
    if (recorded.step != sought.step) return "another step";
    if (a.picks != b.picks || a.batches != b.batches || a.appearances != b.appearances) return "other bodies";
    if (a.poses != b.poses) return "other poses";
    if (!(a == b)) return "another picture";
    if (recorded.length != sought.length || recorded.branches != sought.branches) return "another timeline";
    if (recorded.statistics.bodies != sought.statistics.bodies) return "another number of bodies";
    if (recorded.statistics.energy != sought.statistics.energy) return "another energy";
    return recorded.hasDestruction == sought.hasDestruction ? QString() : QString("another destruction");
}

}  // namespace

class RecordedFramesTest : public QObject {
    Q_OBJECT
private slots:
    void soughtStepIsShownAtOnce() {
        BrokenStage stage;
        for (const std::uint64_t step : {5u, 30u, 12u, 40u, 0u, 11u}) {
            std::optional<PlayFrame> recorded;
            {
                const HeldUp heldUp(stage);
                stage.controller.seek(step);
                stage.controller.applyUpdate();
                recorded = stage.controller.frame();
            }
            QCOMPARE(recorded->step, step);
            QVERIFY(recorded->isRecorded);
            stage.settle();
            QVERIFY(!stage.controller.frame()->isRecorded);
            QCOMPARE(differenceOf(*recorded, *stage.controller.frame()), QString());
        }
    }
    /// Only the last of the seeks is carried out, and nothing on the way to it is shown.
    void everyStepOfADragIsShown() {
        BrokenStage stage;
        std::vector<std::uint64_t> shown;
        connect(&stage.controller, &PlayController::frameChanged, this,
                [&] { shown.push_back(stage.controller.frame()->step); });
        {
            const HeldUp heldUp(stage);
            for (const std::uint64_t step : {35u, 20u, 31u, 8u}) {
                stage.controller.seek(step);
                QCoreApplication::processEvents();
            }
        }
        stage.controller.thread().settle();
        QCoreApplication::sendPostedEvents(&stage.controller);
        QCOMPARE(shown, (std::vector<std::uint64_t>{35, 20, 31, 8, 8}));
        QVERIFY(!stage.controller.frame()->isRecorded);
    }
    void stepsCountFromTheRecordedFrame() {
        BrokenStage stage;
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(20);
            stage.controller.applyUpdate();
            stage.controller.stepOnce();
            stage.controller.applyUpdate();
            QCOMPARE(stage.step(), 21u);
            stage.controller.stepBack();
            stage.controller.applyUpdate();
            stage.controller.stepBack();
            stage.controller.applyUpdate();
            QCOMPARE(stage.step(), 19u);
        }
        stage.settle();
        QCOMPARE(stage.step(), 19u);
    }
    /// What is thrown at the recorded frame hits what it shows, and not what the session still is at.
    void throwAtARecordedFrameActsThere() {
        BrokenStage stage;
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(5);
            stage.controller.applyUpdate();
            stage.controller.throwAlong(test::kAtBlock);
            stage.controller.seek(3);
            stage.controller.applyUpdate();
        }
        stage.settle();
        QCOMPARE(stage.step(), 3u);
        QCOMPARE(stage.controller.frame()->branches.size(), std::size_t{1});
        QCOMPARE(stage.controller.frame()->branches[0].fork, 5u);
        QCOMPARE(stage.controller.frame()->length, 5u);
    }
    void anotherCourseIsRecorded() {
        BrokenStage stage;
        const PlayFrame before = stage.soughtFrame(30);
        stage.controller.seek(5);
        stage.settle();
        Ray above = test::kAtBlock;
        above.from.y += 10.0;
        stage.controller.throwAlong(above);
        stage.settle();
        stage.controller.play();
        stage.settle();
        stage.advance(35);
        const PlayFrame after = stage.soughtFrame(30);
        stage.controller.seek(0);
        stage.settle();
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(30);
            stage.controller.applyUpdate();
            QVERIFY(stage.controller.frame()->isRecorded);
            QCOMPARE(differenceOf(*stage.controller.frame(), after), QString());
        }
        stage.settle();
        const std::uint32_t branch = stage.controller.frame()->branches[0].id;
        stage.controller.switchTo(branch);
        stage.settle();
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(30);
            stage.controller.applyUpdate();
            QCOMPARE(stage.step(), 5u);  // the last one that is known of this course
        }
        stage.settle();
        QCOMPARE(stage.controller.frame()->scene->poses, before.scene->poses);
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(20);
            stage.controller.applyUpdate();
            QCOMPARE(stage.step(), 20u);  // which the seek has played
        }
    }
    void hullsAreRecordedAnew() {
        BrokenStage stage;
        stage.controller.setOverlays({.hasHulls = true});
        stage.settle();
        {
            const HeldUp heldUp(stage);
            stage.controller.seek(20);
            stage.controller.applyUpdate();
            QCOMPARE(stage.step(), 40u);  // nothing is known of it
        }
        stage.settle();
        QCOMPARE(stage.step(), 20u);
        QVERIFY(stage.controller.frame()->scene->batches[0].hulls != nullptr);
    }
    void nearestEarlierStepIsShownWhereMemoryIsShort() {
        const auto scene = test::playSceneOf(test::floatingBlock());
        Session session = Session::start(scene).value();
        SessionSceneBuilder builder(scene);
        RecordedFrames frames(scene, session.stepLength(), 20'000);
        QVERIFY(!frames.frameUntil(0));
        test::addInput(session, BreakInput{1});
        for (int k = 0; k < 200; ++k) {
            session.step();
            frames.add({session.stepsDone(), {.bodies = k}, true}, builder.momentOf(session), {});
        }
        QVERIFY(!frames.frameUntil(0));
        QCOMPARE(frames.frameUntil(1000)->step, 200u);
        bool isShort = false;
        for (std::uint64_t step = 1; step <= 200; ++step) {
            const PlayFrame frame = *frames.frameUntil(step);
            QVERIFY(frame.step <= step);
            QCOMPARE(frame.statistics.bodies, static_cast<int>(frame.step) - 1);
            isShort |= frame.step < step;
        }
        QVERIFY(isShort);
        frames.clear();
        QVERIFY(!frames.frameUntil(1000));
    }
};

RUBBLE_TEST_WITH(RecordedFramesTest, QCoreApplication)
#include "RecordedFramesTest.moc"
