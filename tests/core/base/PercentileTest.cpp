#include "core/base/Percentile.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class PercentileTest : public QObject {
    Q_OBJECT
private slots:
    void nearestRankPercentiles() {
        const std::vector<double> values{5.0, 1.0, 4.0, 2.0, 3.0};
        QCOMPARE(percentile(values, 0.0), 1.0);
        QCOMPARE(percentile(values, 0.2), 1.0);
        QCOMPARE(percentile(values, 0.5), 3.0);
        QCOMPARE(percentile(values, 0.99), 5.0);
        QCOMPARE(percentile(values, 1.0), 5.0);
    }
    void singleValueIsEveryPercentile() { QCOMPARE(percentile({7.0}, 0.5), 7.0); }
};

RUBBLE_TEST(PercentileTest)
#include "PercentileTest.moc"
