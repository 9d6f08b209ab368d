// Tests editor/play/PlayController.cpp and editor/play/PlayThread.cpp over a long time.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"

#include <algorithm>
#include <cstdlib>
#include <random>

#include <malloc.h>

using namespace rubble;

namespace {

/// Random user input.
class Player {
public:
    explicit Player(test::Stage& stage) : m_stage(stage) {}

    void act() {
        PlayController& play = m_stage.controller;
        switch (m_random() % 10) {
            case 0: play.isPlaying() ? play.pause() : play.play(); break;
            case 1: play.seek(m_random() % (play.frame()->length + 1)); break;
            case 2: play.setTimeScale(0.25 * static_cast<double>(1 + m_random() % 8)); break;
            case 3: play.hammerAlong(ray()); break;
            case 4: play.stepOnce(); break;
            case 5: play.setDestruction(!play.hasDestruction()); break;
            case 6:
                play.grabAlong(ray());
                m_stage.advance(5);
                play.dragAlong(ray());
                m_stage.advance(20);
                play.release();
                break;
            default: play.throwAlong(ray(), 1.0); break;
        }
        if (m_random() % 3 != 0) play.play();
        m_stage.advance(static_cast<int>(m_random() % 60));
        m_stage.settle();
    }

private:
    /// A ray from around the house to a random point of it.
    Ray ray() {
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        const Vec3 eye(15.0 * any(m_random), 4.0 + 2.0 * any(m_random), 14.0);
        const Vec3 aim(2.5 * any(m_random), 2.0 + 1.5 * any(m_random), 3.0 * any(m_random));
        return {eye, glm::normalize(aim - eye)};
    }

    test::Stage& m_stage;
    std::mt19937 m_random{9};
};

double megabytesInUse() { return static_cast<double>(mallinfo2().uordblks) / 1e6; }

}  // namespace

class PlayEnduranceTest : public QObject {
    Q_OBJECT
private slots:
    /// Each round restarts the session and measures the memory then. RUBBLE_LONG: 30 minutes of play, else one.
    void randomPlayLeaksNothing() {
        const bool isLong = std::getenv("RUBBLE_LONG") != nullptr;
        const int rounds = isLong ? 90 : 4;
        constexpr double kSecondsOfRound = 20.0;
        test::Stage stage(test::house());
        const std::string bytes = projectText(stage.document.project());
        stage.start();
        Player player(stage);
        qInfo("seed 9, %d rounds", rounds);
        std::vector<double> inUse;
        for (int round = 0; round < rounds; ++round) {
            const double end = stage.controller.thread().now() + kSecondsOfRound;
            while (stage.controller.thread().now() < end) player.act();
            QVERIFY(stage.controller.isInPlay());
            stage.controller.reset();
            stage.settle();
            QCOMPARE(stage.step(), 0u);
            inUse.push_back(megabytesInUse());
        }
        QCOMPARE(projectText(stage.document.project()), bytes);
        QVERIFY(stage.document.undoStack().isClean());
        const auto half = inUse.begin() + rounds / 2;
        const double early = *std::max_element(inUse.begin(), half), late = *std::max_element(half, inUse.end());
        qInfo("in use after a reset: %.2f MB in the first half, %.2f MB in the second", early, late);
        QVERIFY2(late <= 1.05 * early + 0.5, qPrintable(QString::number(late - early)));
    }
};

RUBBLE_TEST_WITH(PlayEnduranceTest, QCoreApplication)
#include "PlayEnduranceTest.moc"
