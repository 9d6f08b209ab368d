#include "editor/panels/models/Histogram.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

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
    void barsCountTheNumbersWithinTheirBounds() {
        Random random(8);
        for (const HistogramAxis axis : {HistogramAxis::Linear, HistogramAxis::Logarithmic}) {
            const std::vector<double> numbers = randomVolumes(random, 500);
            std::vector<bool> isSelected;
            for (std::size_t k = 0; k < numbers.size(); ++k) isSelected.push_back(random.unit() < 0.3);
            const auto bars = histogramOf(numbers, isSelected, 24, axis);
            QCOMPARE(bars.size(), std::size_t{24});
            for (std::size_t bar = 0; bar < bars.size(); ++bar) {
                std::uint32_t count = 0, selected = 0;
                for (std::size_t k = 0; k < numbers.size(); ++k) {
                    const bool isLast = bar + 1 == bars.size();
                    const bool isIn = numbers[k] >= bars[bar].min &&
                                      (isLast ? numbers[k] <= bars[bar].max : numbers[k] < bars[bar].max);
                    count += isIn;
                    selected += isIn && isSelected[k];
                }
                QCOMPARE(bars[bar].count, count);
                QCOMPARE(bars[bar].selected, selected);
            }
        }
    }
    void boundsGrowByStepsOrFactors() {
        const std::vector<double> numbers{1.0, 16.0};
        const auto linear = histogramOf(numbers, {false, false}, 3, HistogramAxis::Linear);
        QCOMPARE(linear[1].min, 6.0);
        QCOMPARE(linear[2].min, 11.0);
        const auto logarithmic = histogramOf(numbers, {false, false}, 4, HistogramAxis::Logarithmic);
        QCOMPARE(logarithmic[1].min, 2.0);
        QCOMPARE(logarithmic[3].min, 8.0);
    }
    void equalNumbersGiveOneBar() {
        const std::vector<double> numbers{0.25, 0.25, 0.25};
        const auto bars = histogramOf(numbers, {true, false, true}, 30, HistogramAxis::Logarithmic);
        QCOMPARE(bars.size(), std::size_t{1});
        QCOMPARE(bars[0].count, 3u);
        QCOMPARE(bars[0].selected, 2u);
        QVERIFY(histogramOf({}, {}, 30, HistogramAxis::Linear).empty());
    }
};

RUBBLE_TEST(HistogramTest)
#include "HistogramTest.moc"
