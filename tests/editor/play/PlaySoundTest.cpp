// Tests what editor/play/PlayThread.cpp says is heard.
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

using namespace rubble;

namespace {

/// A stage whose block is hit and breaks, and what was heard of it.
struct HeardStage {
    explicit HeardStage() {
        QObject::connect(
            &stage.controller.thread(), &PlayThread::cuesPlayed, &stage.controller.thread(),
            [this](const std::vector<SoundCue>& played, double shownAfter) {
                cues.insert(cues.end(), played.begin(), played.end());
                after = shownAfter;
            },
            Qt::DirectConnection);
        stage.controller.setToolSettings(test::heavyBox());
        stage.start();
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(30);
    }
    std::vector<SoundCue> heard() { return std::exchange(cues, {}); }

    std::vector<SoundCue> cues;
    double after = 0.0;  // s
    test::Stage stage;
};

bool areSame(const SoundCue& a, const SoundCue& b) {
    return a.time == b.time && a.kind == b.kind && a.energy == b.energy && a.point == b.point;
}

}  // namespace

class PlaySoundTest : public QObject {
    Q_OBJECT
private slots:
    void playedStepsAreHeard() {
        HeardStage heard;
        const std::vector<SoundCue> cues = heard.heard();
        QCOMPARE(std::ranges::count(cues, CueKind::Broken, &SoundCue::kind), 1);
        const std::uint64_t step = heard.stage.controller.events().breaks().front()->record.step;
        const auto broken = std::ranges::find(cues, CueKind::Broken, &SoundCue::kind);
        QVERIFY(std::abs(broken->time - static_cast<double>(step) * test::Stage::kStep) < 1e-9);
        QVERIFY(std::abs(heard.after - test::Stage::kStep) < 1e-9);
    }
    void soughtAndSingleStepsAreSilent() {
        HeardStage heard;
        (void)heard.heard();
        const std::uint64_t broken = heard.stage.controller.events().breaks().front()->record.step;
        heard.stage.controller.seek(broken);
        heard.stage.settle();
        heard.stage.controller.seek(30);
        heard.stage.settle();
        heard.stage.controller.seek(0);
        heard.stage.settle();
        for (int k = 0; k < 30; ++k) heard.stage.controller.stepOnce();
        heard.stage.settle();
        QCOMPARE(heard.stage.step(), 30u);
        QVERIFY(heard.heard().empty());
    }
    void stepsThatArePlayedAgainSoundTheSame() {
        HeardStage heard;
        const std::vector<SoundCue> first = heard.heard();
        heard.stage.controller.seek(0);
        heard.stage.settle();
        heard.stage.controller.play();
        heard.stage.settle();
        heard.stage.advance(30);
        QVERIFY(std::ranges::equal(heard.heard(), first, areSame));
    }
    void slowMotionDelaysTheSoundWithThePicture() {
        HeardStage heard;
        heard.stage.controller.seek(0);
        heard.stage.settle();
        heard.stage.controller.setTimeScale(0.1);
        heard.stage.controller.play();
        heard.stage.settle();
        heard.stage.advance(300);
        QVERIFY(std::abs(heard.after - 10.0 * test::Stage::kStep) < 1e-9);
    }
};

RUBBLE_TEST_WITH(PlaySoundTest, QCoreApplication)
#include "PlaySoundTest.moc"
