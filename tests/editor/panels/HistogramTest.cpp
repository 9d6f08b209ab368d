#include "editor/panels/Histogram.h"

#include "core/base/Random.h"
#include "editor/panels/VolumeHistogram.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

std::vector<double> randomVolumes(Random& random, std::size_t count) {
    std::vector<double> volumes;
    for (std::size_t k = 0; k < count; ++k) volumes.push_back(random.between(0.001, 1.0) * random.unit() + 1e-6);
    return volumes;
}

}  // namespace

class HistogramTest : public QObject {
    Q_OBJECT
private slots:
    void everyNumberIsInTheBarThatHoldsIt() {
        Random random(8);
        for (const HistogramAxis axis : {HistogramAxis::Linear, HistogramAxis::Logarithmic}) {
            const std::vector<double> numbers = randomVolumes(random, 500);
            std::vector<bool> isChosen;
            for (std::size_t k = 0; k < numbers.size(); ++k) isChosen.push_back(random.unit() < 0.3);
            const auto bars = histogramOf(numbers, isChosen, 24, axis);
            QCOMPARE(bars.size(), std::size_t{24});
            for (std::size_t bar = 0; bar < bars.size(); ++bar) {
                std::uint32_t count = 0, chosen = 0;
                for (std::size_t k = 0; k < numbers.size(); ++k) {
                    const bool isLast = bar + 1 == bars.size();
                    const bool isIn = numbers[k] >= bars[bar].least &&
                                      (isLast ? numbers[k] <= bars[bar].most : numbers[k] < bars[bar].most);
                    count += isIn;
                    chosen += isIn && isChosen[k];
                }
                QCOMPARE(bars[bar].count, count);
                QCOMPARE(bars[bar].chosen, chosen);
            }
        }
    }
    void boundsGrowByStepsOrByFactors() {
        const std::vector<double> numbers{1.0, 16.0};
        const auto linear = histogramOf(numbers, {false, false}, 3, HistogramAxis::Linear);
        QCOMPARE(linear[1].least, 6.0);
        QCOMPARE(linear[2].least, 11.0);
        const auto logarithmic = histogramOf(numbers, {false, false}, 4, HistogramAxis::Logarithmic);
        QCOMPARE(logarithmic[1].least, 2.0);
        QCOMPARE(logarithmic[3].least, 8.0);
    }
    void numbersThatAreAlikeGiveOneBar() {
        const std::vector<double> numbers{0.25, 0.25, 0.25};
        const auto bars = histogramOf(numbers, {true, false, true}, 30, HistogramAxis::Logarithmic);
        QCOMPARE(bars.size(), std::size_t{1});
        QCOMPARE(bars[0].count, 3u);
        QCOMPARE(bars[0].chosen, 2u);
        QVERIFY(histogramOf({}, {}, 30, HistogramAxis::Linear).empty());
    }
    void clicksDragsAndKeysAskForRanges() {
        VolumeHistogram histogram;
        histogram.resize(300, 150);
        histogram.show();
        histogram.setAxis(HistogramAxis::Linear);
        std::vector<double> volumes;
        for (int k = 0; k <= 100; ++k) volumes.push_back(1.0 + k);
        histogram.setVolumes(volumes, std::vector<bool>(volumes.size(), false));
        QSignalSpy ranged(&histogram, &VolumeHistogram::ranged);
        const auto middle = [&](int bar) { return histogram.placeOf(bar).center().toPoint(); };
        QTest::mouseClick(&histogram, Qt::LeftButton, {}, middle(3));
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[3].least);
        QVERIFY(ranged.back()[1].toDouble() < histogram.bars()[3].most && !ranged.back()[2].toBool());
        QTest::mousePress(&histogram, Qt::LeftButton, Qt::ControlModifier, middle(9));
        QMouseEvent move(QEvent::MouseMove, QPointF(middle(5)), histogram.mapToGlobal(QPointF(middle(5))), Qt::NoButton,
                         Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&histogram, &move);
        QTest::mouseRelease(&histogram, Qt::LeftButton, Qt::ControlModifier, middle(5));
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[5].least);
        QVERIFY(ranged.back()[1].toDouble() < histogram.bars()[9].most && ranged.back()[2].toBool());
        QTest::keyClick(&histogram, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[6].least);
        QTest::mouseClick(&histogram, Qt::LeftButton, {}, middle(static_cast<int>(histogram.bars().size()) - 1));
        QCOMPARE(ranged.back()[1].toDouble(), 101.0);  // the last bar holds the largest
    }
    void twentyThousandAreSortedInNoTime() {
        Random random(3);
        const std::vector<double> volumes = randomVolumes(random, 20'000);
        const std::vector<bool> isChosen(volumes.size(), true);
        QElapsedTimer timer;
        timer.start();
        for (int turn = 0; turn < 10; ++turn) histogramOf(volumes, isChosen, 40, HistogramAxis::Logarithmic);
        QVERIFY2(timer.elapsed() < 500, qPrintable(QString::number(timer.elapsed())));  // a fiftieth of it, undisturbed
    }
};

QTEST_MAIN(HistogramTest)
#include "HistogramTest.moc"
