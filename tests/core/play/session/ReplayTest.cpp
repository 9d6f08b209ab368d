#include "core/play/session/Replay.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/Sessions.h"

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

constexpr int kSteps = 150;

/// The house hit by two shots, of which the second comes while the first is under way.
Replay recorded(const std::shared_ptr<const PlayScene>& scene) {
    Result<Session> session = Session::start(scene);
    for (const Shot& shot : scene->project.shots) {
        if (!session->add(shot)) qFatal("a shot cannot be fired");
    }
    ReplayRecorder recorder(*session, "1", {1, 2});
    for (int step = 0; step < kSteps; ++step) {
        if (step == 50) test::addInput(*session, GravityInput{{0.0, -5.0, 0.0}});
        session->step();
        recorder.add(*session);
    }
    return recorder.replay();
}

ReplayPlayer playerOf(const std::shared_ptr<const PlayScene>& scene, const Replay& replay, int threads = 1) {
    Result<ReplayPlayer> player = ReplayPlayer::start(scene, replay, {.threads = threads});
    if (!player) qFatal("%s", player.error().message.c_str());
    return std::move(*player);
}

}  // namespace

class ReplayTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_scene = test::playSceneOf(test::house());
        m_replay = recorded(m_scene);
    }

    void replayHoldsInputsHashesAndKeyframes() {
        QCOMPARE(m_replay.inputs.size(), 4u);
        QCOMPARE(m_replay.inputs[0].step, 30u);  // half a second
        QCOMPARE(m_replay.inputs[3].step, 50u);
        QCOMPARE(m_replay.steps.size(), std::size_t{kSteps});
        QCOMPARE(m_replay.keyframes.size(), 2u);
        QVERIFY(m_replay.steps[0].moved.size() == 77);  // the house settles
        QVERIFY(m_replay.steps[60].moved.size() > 10);
    }

    void playbackReachesTheLastStep() {
        for (const int threads : {1, 2, 16}) {
            ReplayPlayer player = playerOf(m_scene, m_replay, threads);
            QVERIFY(player.seek(kSteps).hasValue());
            QVERIFY(!player.divergence());
            QCOMPARE(player.session().hash().low, m_replay.steps.back().hash);
        }
    }

    void recordingItsInputsAgainGivesTheSameReplay() {
        const Result<Replay> again = rubble::recordReplay(m_scene, {}, m_replay.inputs, kSteps, "1", {1, 2});
        QVERIFY(again.hasValue());
        QVERIFY(*again == m_replay);
    }

    void eventsAreChecked() {
        Replay changed = m_replay;
        changed.steps[59].events = *changed.steps[59].events + 1;
        ReplayPlayer player = playerOf(m_scene, changed);
        QVERIFY(player.seek(kSteps).hasValue());
        QVERIFY(player.divergence().has_value());
        QCOMPARE(player.divergence()->diagnostic().message,
                 std::string("At step 60 the scene reports other events than in the recording."));
    }
    void recordingsWithoutEventsAreOtherwiseChecked() {
        Replay older = m_replay;
        for (ReplayStep& step : older.steps) step.events.reset();
        ReplayPlayer player = playerOf(m_scene, older);
        QVERIFY(player.seek(kSteps).hasValue());
        QVERIFY(!player.divergence());
    }

    void seeksForwardsAndBackwards() {
        ReplayPlayer player = playerOf(m_scene, m_replay);
        for (const std::uint64_t step : {100, 40, 41, 149, 0, 60, 59, 150, 149, 1, 1000}) {
            QVERIFY(player.seek(step).hasValue());
            const std::uint64_t at = std::min<std::uint64_t>(step, kSteps);
            QCOMPARE(player.session().stepsDone(), at);
            if (at > 0) QCOMPARE(player.session().hash().low, m_replay.steps[at - 1].hash);
        }
        QVERIFY(!player.divergence());
    }

    void namesTheFirstStepAndBodyThatDiverge() {
        Project altered = test::house();
        altered.assets[0].threshold = 1300.0;  // what breaks costs more
        ReplayPlayer player = playerOf(test::playSceneOf(altered), m_replay);
        QVERIFY(player.seek(kSteps).hasValue());
        QVERIFY(player.divergence().has_value());
        const std::uint64_t step = player.divergence()->step;
        ReplayPlayer same = playerOf(m_scene, m_replay);
        QVERIFY(same.seek(step - 1).hasValue());
        ReplayPlayer other = playerOf(test::playSceneOf(altered), m_replay);
        QVERIFY(other.seek(step - 1).hasValue());
        QVERIFY(same.session().hash() == other.session().hash());  // until then nothing differed
        const std::string message = player.divergence()->diagnostic().message;
        QVERIFY2(message.starts_with("At step 38 "), message.c_str());
        QVERIFY(player.divergence()->distance.has_value());
        QCOMPARE(player.divergence()->distance->step, 60u);
        QVERIFY(player.divergence()->distance->metres > 0.0);
        QVERIFY(!player.divergence()->distance->body.empty());
    }

    void namesTheBodyThatBreaksOnOneSideOnly() {
        const Session first = sessionWhere([](const Session& session) { return !session.events().breaks.empty(); });
        const auto hardest = std::ranges::max_element(first.events().breaks, {}, &PlayBreak::impact);
        const auto step = static_cast<std::size_t>(first.stepsDone()) - 1;
        Project unbreakable = test::house();
        for (Asset& asset : unbreakable.assets) asset.threshold = 1e9;
        ReplayPlayer missing = playerOf(test::playSceneOf(unbreakable), m_replay);
        QVERIFY(missing.seek(kSteps).hasValue());
        QCOMPARE(missing.divergence()->step, first.stepsDone());
        QCOMPARE(missing.divergence()->kind, DivergenceKind::DidNotBreak);
        QCOMPARE(missing.divergence()->body, first.nameOf(hardest->body));
        QCOMPARE(missing.divergence()->difference, hardest->impact);
        QCOMPARE(missing.divergence()->place.asset, hardest->body.asset->bake->asset);

        Project firm = test::house();
        for (Instance& instance : firm.instances) instance.isUnbreakable = true;
        ReplayPlayer unbroken = playerOf(test::playSceneOf(firm), m_replay);
        QVERIFY(unbroken.seek(kSteps).hasValue());
        QCOMPARE(unbroken.divergence()->kind, DivergenceKind::DidNotBreak);

        Replay without = m_replay;
        without.steps[step].broke.clear();
        without.steps[step].hash ^= 1;
        ReplayPlayer added = playerOf(m_scene, without);
        QVERIFY(added.seek(kSteps).hasValue());
        QCOMPARE(added.divergence()->kind, DivergenceKind::Broke);
        QCOMPARE(added.divergence()->body, first.nameOf(hardest->body));
        const Diagnostic diagnostic = added.divergence()->diagnostic();
        QCOMPARE(diagnostic.code, DiagnosticCode::ReplayMismatch);
        QCOMPARE(diagnostic.place.asset, hardest->body.asset->bake->asset);
        QVERIFY2(QString::fromStdString(diagnostic.message).contains("breaks under an impact of"),
                 diagnostic.message.c_str());
    }

    void namesTheBodyWhoseVelocityDiffersMost() {
        Replay altered = m_replay;
        std::vector<BodyCheck>& moved = altered.steps[9].moved;
        for (const std::size_t k : {2, 5, 7}) moved[k].check ^= 1;
        moved[2].velocity.x += 0.25;
        moved[5].velocity.y += 0.75;
        ReplayPlayer player = playerOf(m_scene, altered);
        QVERIFY(player.seek(20).hasValue());
        QCOMPARE(player.divergence()->step, 10u);
        QCOMPARE(player.divergence()->kind, DivergenceKind::Velocity);
        QCOMPARE(player.divergence()->body, player.session().nameOf(*player.session().body(moved[5].body)));
        QVERIFY(std::abs(player.divergence()->difference - 0.75) < 1e-9);
        altered.isDetailed = false;  // as recordings of version 1: the lowest-numbered one
        ReplayPlayer old = playerOf(m_scene, altered);
        QVERIFY(old.seek(20).hasValue());
        QCOMPARE(old.divergence()->kind, DivergenceKind::Unmeasured);
        QCOMPARE(old.divergence()->body, old.session().nameOf(*old.session().body(moved[2].body)));
    }

    void oneAlteredInputIsNamed() {
        Replay altered = m_replay;
        std::get<Throw>(std::get<ShotInput>(altered.inputs[0].input).action).speed += 1e-3;
        ReplayPlayer player = playerOf(m_scene, altered);
        QVERIFY(player.seek(kSteps).hasValue());
        QVERIFY(player.divergence().has_value());
        QVERIFY2(player.divergence()->step >= 31, player.divergence()->diagnostic().message.c_str());
    }

    void cancellationStops() {
        ReplayPlayer player = playerOf(m_scene, m_replay);
        const CancelToken cancel;
        cancel.cancel();
        QCOMPARE(player.seek(9, {.cancel = cancel}).error().code, ErrorCode::Cancelled);
    }

private:
    /// The recorded session after the first step for which a condition holds.
    template <class Condition>
    Session sessionWhere(Condition isMet) const {
        Result<Session> session = Session::start(m_scene);
        for (const TimedInput& input : m_replay.inputs) {
            if (!session->add(input)) qFatal("an input cannot be added");
        }
        do session->step();
        while (!isMet(*session) && session->stepsDone() < kSteps);
        return std::move(*session);
    }

    std::shared_ptr<const PlayScene> m_scene;
    Replay m_replay;
};

RUBBLE_TEST(ReplayTest)
#include "ReplayTest.moc"
