#include "core/asset/mesh/OutlineInterval.h"

#include "tests/support/TestProgram.h"

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

Ring regularRing(std::size_t corners) {
    Ring ring;
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
        ring.push_back({std::cos(angle), std::sin(angle)});
    }
    return ring;
}

}  // namespace

class OutlineIntervalTest : public QObject {
    Q_OBJECT
private slots:
    void lengthsStartAtTheFirstCorner() {
        const OutlineIndex square({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}});
        const OutlineInterval right = square.nearestInterval({1.0, 0.25}, {1.0, 0.75});
        QCOMPARE(right.from, 1.25);
        QCOMPARE(right.to, 1.75);
        QCOMPARE(right.distance, 0.0);
        const OutlineInterval above = square.nearestInterval({0.75, 1.5}, {0.25, 1.5});
        QCOMPARE(above.from, 2.25);
        QCOMPARE(above.distance, 0.5);
    }
    void clockwiseOutlinesAreMeasuredBackwards() {
        const OutlineIndex square({{{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}}, {}});
        const OutlineInterval right = square.nearestInterval({1.0, 0.25}, {1.0, 0.75});
        QCOMPARE(right.from, -2.75);
        QCOMPARE(right.to, -2.25);
    }
    void holesHaveLengthsOfTheirOwn() {
        const OutlineIndex frame(
            {{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}, {{{1.0, 1.0}, {1.0, 3.0}, {3.0, 3.0}, {3.0, 1.0}}}});
        const OutlineInterval left = frame.nearestInterval({1.0, 1.5}, {1.0, 2.5});
        QCOMPARE(left.from, 0.5);
        QCOMPARE(left.to, 1.5);
    }
    void intervalsAreFoundInFewVisits() {
        const Ring ring = regularRing(16000);
        const OutlineIndex index({ring, {}});
        std::size_t visited = 0;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const OutlineInterval interval = index.nearestInterval(ring[k], ring[(k + 1) % ring.size()], &visited);
            QVERIFY(interval.distance < 1e-15);
        }
        QVERIFY2(visited < 16u * ring.size(), qPrintable(QString::number(visited)));
    }
};

RUBBLE_TEST(OutlineIntervalTest)
#include "OutlineIntervalTest.moc"
