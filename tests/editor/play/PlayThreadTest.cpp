// Tests editor/play/PlayThread.cpp.
#include "editor/play/PlayThread.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QTest>

using namespace rubble;

class PlayThreadTest : public QObject {
    Q_OBJECT
private slots:
    void slowStepsAreShownAsSlowly() {
        test::Stage stage(test::floatingBlock(), test::Stage::Clock::Real);
        constexpr double kFast = 1e6;  // every step takes longer than it shows
        stage.controller.setTimeScale(kFast);
        stage.controller.play();
        QTRY_VERIFY(stage.controller.frame() && stage.controller.frame()->step >= 3);
        QVERIFY(stage.controller.frame()->shownFor > 1.5 * test::Stage::kStep / kFast);
    }
};

RUBBLE_TEST(PlayThreadTest)
#include "PlayThreadTest.moc"
