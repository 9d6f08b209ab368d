// Tests viewport/widget/AdaptiveQuality.cpp.
#include "viewport/render/Renderer.h"
#include "viewport/widget/AdaptiveQuality.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// The resolution after many images that take `fixed` s and, at full resolution, `full` s for their pixels.
double settled(double fixed, double full) {
    AdaptiveQuality quality;
    for (int image = 0; image < 50; ++image) quality.add(fixed + full * quality.resolution() * quality.resolution());
    return quality.resolution();
}

}  // namespace

class AdaptiveQualityTest : public QObject {
    Q_OBJECT
private slots:
    void fastImagesHaveFullResolution() { QCOMPARE(settled(0.002, 0.01), 1.0); }
    void slowImagesReachTheGoal() {
        const double fixed = 0.008, full = 0.08, value = settled(fixed, full);
        QVERIFY(value < 1.0 && value > AdaptiveQuality::kLowest);
        const double seconds = fixed + full * value * value;
        QVERIFY2(seconds <= AdaptiveQuality::kGoal && seconds > 0.75 * AdaptiveQuality::kGoal,
                 qPrintable(QString::number(seconds)));
    }
    void theGoalIsReachedWithinAFewImages() {
        AdaptiveQuality quality;
        int images = 0;
        double seconds = 1.0;
        for (; seconds > AdaptiveQuality::kGoal && images < 20; ++images) {
            seconds = 0.005 + 0.12 * quality.resolution() * quality.resolution();
            quality.add(seconds);
        }
        QVERIFY2(images <= 4, qPrintable(QString::number(images)));
    }
    void resolutionHasALowerBound() { QCOMPARE(settled(1.0, 1.0), AdaptiveQuality::kLowest); }
    void fewerFragmentsAreDrawnApartAtLowerQuality() {
        AdaptiveQuality quality;
        QCOMPARE(quality.minFragmentPixels(), kMinFragmentPixels);
        double before = 0.0;
        for (; !quality.isLowest(); quality.add(1.0)) {
            QVERIFY(quality.minFragmentPixels() > before);
            before = quality.minFragmentPixels();
        }
        QVERIFY(quality.minFragmentPixels() > 20.0 && quality.minFragmentPixels() < 30.0);
    }
    void resolutionRisesAgain() {
        AdaptiveQuality quality;
        for (int image = 0; image < 10; ++image) quality.add(0.2);
        for (int image = 0; image < 20; ++image) quality.add(0.004);
        QCOMPARE(quality.resolution(), 1.0);
    }
};

RUBBLE_TEST_WITH(AdaptiveQualityTest, QCoreApplication)
#include "AdaptiveQualityTest.moc"
