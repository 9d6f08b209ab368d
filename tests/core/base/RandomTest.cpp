#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class RandomTest : public QObject {
    Q_OBJECT
private slots:
    void streamsAreFixed() {
        Random random(1);
        const std::uint64_t first = random.next();
        Random again(1);
        QCOMPARE(again.next(), first);
        QVERIFY(Random(2).next() != first);
        QCOMPARE(first, std::uint64_t{12966619160104079557u});
    }
    void unitIsUniformInHalfOpenInterval() {
        Random random(7);
        double sum = 0.0;
        for (int i = 0; i < 100000; ++i) {
            const double value = random.unit();
            QVERIFY(value >= 0.0 && value < 1.0);
            sum += value;
        }
        QVERIFY(std::abs(sum / 100000.0 - 0.5) < 0.005);  // five standard deviations of the mean
    }
    void belowHitsEveryValue() {
        Random random(3);
        int hits[5] = {};
        for (int i = 0; i < 5000; ++i) ++hits[random.below(5)];
        for (const int hit : hits) QVERIFY(hit > 850 && hit < 1150);
    }
    void betweenReturnsLowForEmptyRange() { QCOMPARE(Random(1).between(2.0, 2.0), 2.0); }
};

RUBBLE_TEST(RandomTest)
#include "RandomTest.moc"
