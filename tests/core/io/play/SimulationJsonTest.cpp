#include "core/io/play/SimulationJson.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

SimulationOutcome outcome() {
    SimulationOutcome outcome;
    outcome.steps = 3;
    outcome.bodies = {{"floor", {}, false}, {"crate", {{0.0, 0.5, -1.25}, {0.0, 0.0, 1.0, 0.0}}, true}};
    outcome.counts = {2.0, 1.5, 4.0};
    outcome.largestPenetration = 0.0625;
    outcome.hash = {1, 2};
    return outcome;
}

}  // namespace

class SimulationJsonTest : public QObject {
    Q_OBJECT
private slots:
    void resultIsWrittenInOrder() {
        QCOMPARE(QString::fromStdString(simulationJson(outcome())), QString(R"({
  "steps": 3,
  "bodies": [
    {"name": "floor", "position": [0, 0, 0], "orientation": [1, 0, 0, 0], "asleep": false},
    {"name": "crate", "position": [0, 0.5, -1.25], "orientation": [0, 0, 1, 0], "asleep": true}
  ],
  "counts": {"bodies": 2, "pairs": 1.5, "contactPoints": 4},
  "swaps": 0,
  "breaks": [],
  "splits": [],
  "largestPenetration": 0.0625,
  "hash": "00000000000000010000000000000002"
}
)"));
    }
    void breaksAndTimesAreWrittenIfPresent() {
        SimulationOutcome broken = outcome();
        broken.breaks = {{2, "crate", 12.5, 10.0, {1.0, 2.0, 3.0}, 8}};
        broken.stepMilliseconds = StepMilliseconds{0.5, 0.75, 1.0};
        const QString json = QString::fromStdString(simulationJson(broken));
        QVERIFY(json.contains(R"("swaps": 1,)"));
        QVERIFY(json.contains(
            R"({"step": 2, "body": "crate", "impact": 12.5, "threshold": 10, "point": [1, 2, 3], "fragments": 8})"));
        QVERIFY(json.contains(R"("stepMilliseconds": {"median": 0.5, "p99": 0.75, "max": 1})"));
    }
};

RUBBLE_TEST(SimulationJsonTest)
#include "SimulationJsonTest.moc"
