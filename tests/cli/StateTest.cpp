// Tests that rubble-cli simulate goes on from the states that it saves.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

const QString kHouseFile = RUBBLE_SOURCE_DIR "/projects/house.rubble";

ProgramOutcome simulateHouse(QStringList arguments) {
    return runProgram(RUBBLE_CLI, QStringList{"simulate", kHouseFile} + arguments);
}

QJsonObject resultOf(const ProgramOutcome& ended) { return QJsonDocument::fromJson(ended.output.toUtf8()).object(); }

}  // namespace

class StateTest : public QObject {
    Q_OBJECT
private slots:
    void goesOnWithTheSameBits() {
        const QTemporaryDir folder;
        const QString state = folder.filePath("door.rubblestate");
        const QStringList shot{"--shot", "box at the door"};
        const ProgramOutcome all = simulateHouse(QStringList{"--steps", "90"} + shot);
        QCOMPARE(simulateHouse(QStringList{"--steps", "50", "--save-state", state} + shot).error, QString());
        const ProgramOutcome rest = simulateHouse({"--steps", "40", "--state", state, "-j", "2"});
        QCOMPARE(rest.exit, 0);
        QVERIFY(!resultOf(all)["hash"].toString().isEmpty());
        QCOMPARE(resultOf(rest)["hash"], resultOf(all)["hash"]);
        QCOMPARE(resultOf(rest)["bodies"], resultOf(all)["bodies"]);
    }
    void timesOfShotsCountFromTheState() {
        const QTemporaryDir folder;
        const QString state = folder.filePath("start.rubblestate");
        QCOMPARE(simulateHouse({"--steps", "30", "--save-state", state}).exit, 0);
        const ProgramOutcome ended = simulateHouse({"--steps", "90", "--state", state, "--shot", "box at the door"});
        QVERIFY2(!resultOf(ended)["breaks"].toArray().isEmpty(), qPrintable(ended.error));
    }
    void aSmallStateSleepsAndTellsWhatItDropped() {
        const QTemporaryDir folder;
        const QString state = folder.filePath("small.rubblestate");
        const ProgramOutcome saved =
            simulateHouse({"--steps", "50", "--shot", "box at the door", "--save-state", state, "--small"});
        QCOMPARE(saved.exit, 0);
        QVERIFY2(saved.error.contains("still moving; the small state holds where they were, at rest."),
                 qPrintable(saved.error));
        const QJsonObject loaded = resultOf(simulateHouse({"--steps", "100", "--state", state}));
        const QJsonArray before = resultOf(saved)["bodies"].toArray(), after = loaded["bodies"].toArray();
        QCOMPARE(after.size(), before.size());
        for (qsizetype k = 0; k < after.size(); ++k) QCOMPARE(after[k]["name"], before[k]["name"]);
    }
    void anotherProjectIsRefused() {
        const QTemporaryDir folder;
        const QString state = folder.filePath("house.rubblestate");
        QCOMPARE(simulateHouse({"--steps", "1", "--save-state", state}).exit, 0);
        const ProgramOutcome ended = runProgram(
            RUBBLE_CLI, {"simulate", RUBBLE_SOURCE_DIR "/projects/pane.rubble", "--steps", "1", "--state", state});
        QCOMPARE(ended.exit, 1);
        QVERIFY2(ended.error.contains("The state was saved from another scene"), qPrintable(ended.error));
    }
    /// The front has broken; in the changed project its asset has fewer seeds.
    void damageOfAnEarlierVersionIsRemapped() {
        const QTemporaryDir folder;
        const QString state = folder.filePath("door.rubblestate"), changed = folder.filePath("changed.rubble");
        const ProgramOutcome saved =
            simulateHouse({"--steps", "90", "--shot", "box at the door", "--save-state", state});
        const auto broken = resultOf(saved)["breaks"].toArray().size();
        QVERIFY(broken > 0);
        Result<Project> project = loadProject(kHouseFile.toStdString());
        for (Asset& asset : project->assets) ++asset.pattern.layers[0].randomSeed;
        QVERIFY(saveProject(changed.toStdString(), *project));
        const QStringList start{"simulate", changed, "--steps", "1", "--state", state};
        QCOMPARE(runProgram(RUBBLE_CLI, start).exit, 1);
        const ProgramOutcome remapped = runProgram(RUBBLE_CLI, start + QStringList{"--remap", kHouseFile});
        QVERIFY2(remapped.exit == 0 && remapped.error.isEmpty(), qPrintable(remapped.error));
        const auto bodies = resultOf(remapped)["bodies"].toArray().size();
        QCOMPARE(bodies, resultOf(saved)["bodies"].toArray().size() - 1);  // the thrown box is not damage
        project->instances.clear();
        project->playTests.clear();
        QVERIFY(saveProject(changed.toStdString(), *project));
        const ProgramOutcome empty = runProgram(RUBBLE_CLI, start + QStringList{"--remap", kHouseFile});
        QVERIFY2(empty.exit == 0 && empty.error.contains(" is gone; its damage is dropped."), qPrintable(empty.error));
    }
    void optionsOfTheStartAreRefused() {
        const ProgramOutcome ended = simulateHouse({"--steps", "1", "--state", "x.rubblestate", "--dt", "0.01"});
        QVERIFY(ended.exit != 0);
        QVERIFY2(ended.error.contains("--dt"), qPrintable(ended.error));
    }
};

RUBBLE_TEST(StateTest)
#include "StateTest.moc"
