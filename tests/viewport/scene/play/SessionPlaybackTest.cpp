#include "tests/support/TestProgram.h"
#include "viewport/scene/play/SessionPlayback.h"

#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

const ShotInput kThrow{"throw", test::throwAtBlock(3.0, 80.0)};

SessionPlayback playbackOf(std::vector<TimedInput> inputs) {
    const auto scene = test::playSceneOf(test::floatingBlock());
    return SessionPlayback(scene, Session::start(scene).value(), std::move(inputs));
}

}  // namespace

class SessionPlaybackTest : public QObject {
    Q_OBJECT
private slots:
    void playsToRequestedSteps() {
        SessionPlayback playback = playbackOf({{3, kThrow}});
        QVERIFY(playback.sceneAtStep(3).hasValue());
        QCOMPARE(test::countOf(playback.session(), PlayRole::Projectile), 0u);
        QVERIFY(playback.sceneAtStep(4).hasValue());
        QCOMPARE(test::countOf(playback.session(), PlayRole::Projectile), 1u);
        QVERIFY(playback.sceneAtStep(200).hasValue());
        QCOMPARE(playback.session().stepsDone(), 200u);
        QVERIFY(test::countOf(playback.session(), PlayRole::Debris) > 1);
    }
    void inputsApplyAtTheirSteps() {
        SessionPlayback playback = playbackOf({{0, kThrow}, {7, GravityInput{{0.0, -9.0, 0.0}}}});
        QVERIFY(playback.sceneAtStep(40).hasValue());
        Session session = test::sessionOf(test::floatingBlock());
        test::addInput(session, kThrow);
        for (int step = 0; step < 40; ++step) {
            if (step == 7) test::addInput(session, GravityInput{{0.0, -9.0, 0.0}});
            session.step();
        }
        QCOMPARE(playback.session().hash(), session.hash());
    }
    void sceneHasPreviousPoses() {
        SessionPlayback playback = playbackOf({{0, kThrow}});
        for (const std::uint64_t step : {5u, 80u}) {
            const auto moment = playback.sceneAtStep(step);
            QCOMPARE((*moment)->previousPoses.size(), (*moment)->poses.size());
        }
    }
    void sameStepCanBeRequestedAgain() {
        SessionPlayback playback = playbackOf({});
        const auto first = playback.sceneAtStep(5);
        QCOMPARE((*playback.sceneAtStep(5))->poses, (*first)->poses);
    }
    void eachStepIsReportedOnceItIsDone() {
        SessionPlayback playback = playbackOf({{0, kThrow}});
        std::vector<std::uint64_t> steps;
        playback.setAfterStep([&](const Session& session) { steps.push_back(session.stepsDone()); });
        QVERIFY(playback.sceneAtStep(3).hasValue());
        QCOMPARE(steps, (std::vector<std::uint64_t>{1, 2, 3}));
        playback.setAfterStep({});
        QVERIFY(playback.sceneAtStep(90).hasValue());
        QCOMPARE(steps.size(), std::size_t{3});
    }
    /// Scenes are built of the last second only; dust of the steps before it would be gone anyway.
    void dustIsThatOfTheSameStepHoweverItIsReached() {
        SessionPlayback stepwise = playbackOf({{0, kThrow}}), atOnce = playbackOf({{0, kThrow}});
        std::size_t most = 0;
        for (std::uint64_t step = 1; step <= 20; ++step) {
            most = std::max(most, (*stepwise.sceneAtStep(step))->particles.size());
        }
        QVERIFY(most > 10);
        QVERIFY((*atOnce.sceneAtStep(20))->particles == (*stepwise.sceneAtStep(20))->particles);
    }
    void invalidInputBecomesADiagnostic() {
        SessionPlayback playback = playbackOf({{2, GrabInput{.body = 77, .force = 1.0}}, {3, kThrow}});
        QVERIFY(playback.sceneAtStep(5).hasValue());
        const std::vector<Diagnostic> reported = playback.drainDiagnostics();
        QCOMPARE(reported.size(), std::size_t{1});
        QCOMPARE(reported[0].code, DiagnosticCode::UnappliedInput);
        QCOMPARE(reported[0].message, std::string("Cannot grab: there is no body 77."));
        QVERIFY(playback.drainDiagnostics().empty());
        QCOMPARE(test::countOf(playback.session(), PlayRole::Projectile), 1u);
    }
    void canBeCancelled() {
        SessionPlayback playback = playbackOf({});
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(playback.sceneAtStep(5, task).error().code, ErrorCode::Cancelled);
        QCOMPARE(playback.session().stepsDone(), 0u);
    }
};

RUBBLE_TEST(SessionPlaybackTest)
#include "SessionPlaybackTest.moc"
