#include "editor/background/VideoEstimate.h"

#include "tests/support/TestProgram.h"
#include "tests/support/viewport/StarterScene.h"

#include <QTest>

using namespace rubble;

class VideoEstimateTest : public QObject {
    Q_OBJECT
private slots:
    void moreSamplesTakeLonger() {
        const double good = measured(samplesOf(RenderQuality::Good)), best = measured(samplesOf(RenderQuality::Best));
        if (good == 0.0) QSKIP("There is no OpenGL.");
        QVERIFY2(best > 1.5 * good, qPrintable(QString("%1 s, %2 s").arg(good).arg(best)));
        QVERIFY(measured(0) > 0.0);
    }
    void anotherMeasurementReplacesIt() {
        VideoEstimate estimate;
        estimate.measure(test::starterScene(), {.size = {1920, 1080}}, 128);
        QVERIFY(estimate.isMeasuring() && !estimate.secondsPerFrame());
        estimate.measure(test::starterScene(), {.size = {0, 90}}, 0);  // is refused
        QTRY_VERIFY(!estimate.isMeasuring());
        QVERIFY(!estimate.secondsPerFrame());
    }

private:
    /// s; 0 where nothing can be rendered.
    static double measured(int samples) {
        VideoEstimate estimate;
        estimate.measure(test::starterScene(), {.size = {320, 180}}, samples);
        if (!QTest::qWaitFor([&] { return !estimate.isMeasuring(); }, kPatience)) return 0.0;
        return estimate.secondsPerFrame().value_or(0.0);
    }
};

RUBBLE_TEST_WITH(VideoEstimateTest, QCoreApplication)
#include "VideoEstimateTest.moc"
