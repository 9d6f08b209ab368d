#include "editor/background/ForecastRunner.h"

#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QTest>

using namespace rubble;

namespace {

const Ray kAtBlock{{0.0, 5.0, 4.0}, {0.0, 0.0, -1.0}}, kPast{{5.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};

}  // namespace

class ForecastRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void aimedThrowIsForecast() {
        test::Stage stage;
        const ForecastRunner runner(stage.controller);
        stage.controller.setOverlays({.hasHeat = true});
        stage.start();
        stage.controller.pause();
        for (const Ray& ray : {kAtBlock, kPast, kAtBlock}) {
            stage.controller.aim(ray);
            stage.settle();
            QVERIFY(!stage.controller.frame()->hasForecast);
            const auto isShown = [&] {
                stage.settle();
                return stage.controller.frame()->hasForecast;
            };
            QTRY_VERIFY_WITH_TIMEOUT(isShown(), kPatience);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), kPatience);
    }
    void stoppingPlayCancels() {
        test::Stage stage;
        const ForecastRunner runner(stage.controller);
        stage.controller.setOverlays({.hasHeat = true});
        stage.start();
        stage.controller.aim(kAtBlock);
        stage.settle();
        stage.controller.stop();
        QVERIFY(!runner.isBusy());
    }
};

RUBBLE_TEST_WITH(ForecastRunnerTest, QCoreApplication)
#include "ForecastRunnerTest.moc"
