#include "viewport/widget/AdaptiveResolution.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// The resolution after many images that take `fixed` s and, at full resolution, `full` s for their pixels.
double settled(double fixed, double full) {
    AdaptiveResolution resolution;
    for (int image = 0; image < 50; ++image) resolution.add(fixed + full * resolution.value() * resolution.value());
    return resolution.value();
}

}  // namespace

class AdaptiveResolutionTest : public QObject {
    Q_OBJECT
private slots:
    void fastImagesHaveFullResolution() { QCOMPARE(settled(0.002, 0.01), 1.0); }
    void slowImagesReachTheGoal() {
        const double fixed = 0.008, full = 0.08, value = settled(fixed, full);
        QVERIFY(value < 1.0 && value > AdaptiveResolution::kLowest);
        const double seconds = fixed + full * value * value;
        QVERIFY2(seconds <= AdaptiveResolution::kGoal && seconds > 0.75 * AdaptiveResolution::kGoal,
                 qPrintable(QString::number(seconds)));
    }
    void theGoalIsReachedWithinAFewImages() {
        AdaptiveResolution resolution;
        int images = 0;
        double seconds = 1.0;
        for (; seconds > AdaptiveResolution::kGoal && images < 20; ++images) {
            seconds = 0.005 + 0.12 * resolution.value() * resolution.value();
            resolution.add(seconds);
        }
        QVERIFY2(images <= 4, qPrintable(QString::number(images)));
    }
    void resolutionHasALowerBound() { QCOMPARE(settled(1.0, 1.0), AdaptiveResolution::kLowest); }
    void resolutionRisesAgain() {
        AdaptiveResolution resolution;
        for (int image = 0; image < 10; ++image) resolution.add(0.2);
        for (int image = 0; image < 20; ++image) resolution.add(0.004);
        QCOMPARE(resolution.value(), 1.0);
    }
};

RUBBLE_TEST_WITH(AdaptiveResolutionTest, QCoreApplication)
#include "AdaptiveResolutionTest.moc"
