#include "core/base/Parallel.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <vector>

using namespace rubble;

class ParallelTest : public QObject {
    Q_OBJECT
private slots:
    void everyIndexIsVisitedOnceForAnyThreadCount() {
        for (const int threads : {-1, 0, 1, 2, 7, 100}) {
            std::vector<int> calls(50, 0);
            forEachIndex(calls.size(), threads, [&](std::size_t index) { ++calls[index]; });
            QCOMPARE(calls, std::vector<int>(50, 1));
        }
    }
    void zeroIndicesCallNothing() {
        forEachIndex(0, 4, [](std::size_t) { QFAIL("called without an index"); });
    }
};

RUBBLE_TEST(ParallelTest)
#include "ParallelTest.moc"
