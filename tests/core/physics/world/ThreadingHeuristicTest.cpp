#include "core/physics/world/ThreadingHeuristic.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// The number of threaded steps, for given step times.
int threadedSteps(ThreadingHeuristic& heuristic, int steps, double single, double threaded) {
    int count = 0;
    for (int step = 0; step < steps; ++step) {
        const bool isThreaded = heuristic.isThreaded();
        count += isThreaded ? 1 : 0;
        heuristic.addStep(isThreaded ? threaded : single);
    }
    return count;
}

}  // namespace

class ThreadingHeuristicTest : public QObject {
    Q_OBJECT
private slots:
    void fasterThreadedStepsAreThreaded() {
        ThreadingHeuristic heuristic;
        QVERIFY(threadedSteps(heuristic, 2560, 1.0, 0.6) >= 2560 - 100);
    }
    void slowerThreadedStepsAreNotThreaded() {
        ThreadingHeuristic heuristic;
        QVERIFY(threadedSteps(heuristic, 2560, 1.0, 1.5) <= 16 + 50);
    }
    void changesOfTheMachineAreDetected() {
        ThreadingHeuristic heuristic;
        threadedSteps(heuristic, 2560, 1.0, 1.5);
        threadedSteps(heuristic, 256, 1.0, 0.6);
        QVERIFY(threadedSteps(heuristic, 256, 1.0, 0.6) >= 240);
    }
    /// After each change the caches are cold, longer so on several threads.
    void firstStepOfEachKindDoesNotDecide() {
        ThreadingHeuristic heuristic;
        bool wasThreaded = false;
        int threaded = 0;
        for (int step = 0; step < 2560; ++step) {
            const bool isThreaded = heuristic.isThreaded(), isFirst = isThreaded != wasThreaded;
            threaded += isThreaded ? 1 : 0;
            heuristic.addStep(isThreaded ? (isFirst ? 20.0 : 0.6) : (isFirst ? 10.0 : 1.0));
            wasThreaded = isThreaded;
        }
        QVERIFY(threaded >= 2560 - 100);
    }
    void trendOfStepTimesDoesNotDecide() {
        // Every step takes longer than the one before, and 1.2 times as long on several threads.
        ThreadingHeuristic heuristic;
        double single = 1.0;
        int threaded = 0;
        for (int step = 0; step < 256; ++step, single *= 1.05) {
            threaded += heuristic.isThreaded() ? 1 : 0;
            heuristic.addStep(heuristic.isThreaded() ? 1.2 * single : single);
        }
        QVERIFY(threaded <= 16 + 4 * 3);
    }
};

RUBBLE_TEST(ThreadingHeuristicTest)
#include "ThreadingHeuristicTest.moc"
