#include "core/sound/session/SoundRecorder.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Pane.h"
#include "tests/support/play/Sessions.h"

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

SoundRecorder heard(Session& session, int steps) {
    SoundRecorder recorder;
    for (int step = 0; step < steps; ++step) {
        session.step();
        recorder.add(session);
    }
    return recorder;
}

std::size_t countOf(const SoundRecorder& recorder, CueKind kind) {
    return static_cast<std::size_t>(std::ranges::count(recorder.cues(), kind, &SoundCue::kind));
}

}  // namespace

class SoundRecorderTest : public QObject {
    Q_OBJECT
private slots:
    void fallOfABlockIsOneImpactOfItsEnergy() {
        Project project = test::floatingBlock();
        project.gravity = {0.0, -9.81, 0.0};
        project.instances[0].pose.position.y = 1.5;
        project.instances[0].isUnbreakable = true;
        Session session = test::sessionOf(project);
        const SoundRecorder recorder = heard(session, 120);
        QCOMPARE(recorder.cues().size(), 1u);
        const SoundCue& cue = recorder.cues()[0];
        QCOMPARE(cue.kind, CueKind::Impact);
        QVERIFY(std::abs(cue.time - std::sqrt(2.0 / 9.81)) < 0.03);  // it falls 1 m
        QVERIFY(std::abs(cue.energy - 500.0 * 9.81) < 0.1 * 500.0 * 9.81);
        QCOMPARE(cue.mass, 500.0);
        QCOMPARE(cue.second, SoundMaterial::Stone);  // the ground
        QVERIFY(std::abs(cue.point.y) < 0.08);       // within the way of a step
        QCOMPARE(recorder.track({})->frames(), 96000u);
    }
    void breakOfAPaneSoundsOfGlass() {
        Session session = test::sessionOf(test::pane());
        test::addInput(session, ShotInput{"box", Throw{.size = Vec3(0.2),
                                                       .mass = 5.0,
                                                       .from = {-0.1, 1.9, 2.0},
                                                       .to = {-0.1, 1.9, 0.0},
                                                       .speed = 20.0}});
        const SoundRecorder recorder = heard(session, 60);
        QCOMPARE(countOf(recorder, CueKind::Broken), 1u);
        QVERIFY(countOf(recorder, CueKind::Impact) > 0);
        const auto broken = std::ranges::find(recorder.cues(), CueKind::Broken, &SoundCue::kind);
        QCOMPARE(broken->first, SoundMaterial::Glass);
        QVERIFY(std::abs(broken->time - 0.1) < 0.05);  // 2 m at 20 m/s
        QVERIFY(broken->energy > 1.0);
    }
    void restIsSilent() {
        Session session = test::sessionOf(test::floatingBlock());
        const SoundRecorder recorder = heard(session, 30);
        QVERIFY(recorder.cues().empty());
        const StereoTrack track = *recorder.track({});
        QVERIFY(std::ranges::all_of(track.samples, [](std::int16_t value) { return value == 0; }));
    }
    void listenerIsInFrontOfTheScene() {
        const Session session = test::sessionOf(test::floatingBlock());
        const Listener listener = frontListener(session);
        QVERIFY(glm::distance(listener.position, Vec3(0.0, 5.0, 3.0)) < 0.1);
    }
};

RUBBLE_TEST(SoundRecorderTest)
#include "SoundRecorderTest.moc"
