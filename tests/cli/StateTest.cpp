// Tests that app/cli/verbs/SimulateVerb.cpp goes on from the states that it saves.
#include "core/base/Random.h"
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

/// A throw, a blow or a blast somewhere at the front of a wall.
ShotAction randomAction(const Box2& front, Random& random) {
    const Vec3 target(random.between(front.min.x, front.max.x), random.between(front.min.y, front.max.y), 0.0);
    switch (random.below(4)) {
        case 0: return Hammer{.at = target, .impulse = Vec3(0.0, 0.0, -random.between(2000.0, 20000.0))};
        case 1:
            return Blast{.at = target + Vec3(0.0, 0.0, random.between(0.5, 1.5)),
                         .impulse = random.between(3000.0, 20000.0),
                         .radius = random.between(1.0, 3.5)};
        default:
            return Throw{.kind = random.below(2) == 0 ? ProjectileKind::Box : ProjectileKind::Ball,
                         .size = Vec3(random.between(0.3, 1.2)),
                         .mass = random.between(50.0, 3000.0),
                         .from = target + Vec3(random.between(-3.0, 3.0), random.between(-1.0, 2.0), 8.0),
                         .to = target,
                         .speed = random.between(10.0, 40.0)};
    }
}

/// A demo project with up to three random shots within half a second, and their names as options.
struct RandomRun {
    Project project;
    QStringList shots;
};

RandomRun randomRun(const char* name, Random& random) {
    RandomRun run{*loadProject(std::string(RUBBLE_SOURCE_DIR "/projects/") + name + ".rubble"), {}};
    const Box2 front = boundsOf(run.project.assets[0].prism().outline.outer);
    run.project.shots.clear();
    run.project.playTests.clear();
    const std::uint64_t count = 1 + random.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::string shot = "shot " + std::to_string(k);
        run.project.shots.push_back({.id = run.project.nextId++,
                                     .name = shot,
                                     .time = random.between(0.0, 0.5),
                                     .action = randomAction(front, random)});
        run.shots += {"--shot", QString::fromStdString(shot)};
    }
    return run;
}

/// Whether a single fragment came off and is awake.
bool isCollapsing(const QJsonObject& result) {
    const QJsonArray bodies = result["bodies"].toArray();
    return std::any_of(bodies.begin(), bodies.end(), [](const QJsonValue& body) {
        return body["name"].toString().contains('/') && !body["asleep"].toBool();
    });
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
    /// Each run, saved at a random step while it collapses, goes on in a fresh process as if it had not been
    /// interrupted.
    void bondedProjectsGoOnWithTheSameBits() {
        constexpr std::uint64_t kSeed = 47;
        const bool isLong = qEnvironmentVariableIsSet("RUBBLE_LONG");
        const int runs = isLong ? 200 : 4;
        qInfo("seed %d, %d runs", static_cast<int>(kSeed), runs);
        Random random(kSeed);
        const QTemporaryDir folder;
        const QString project = folder.filePath("shots.rubble"), state = folder.filePath("moment.rubblestate");
        const auto after = [&project](int steps, const QStringList& more) {
            const ProgramOutcome ended =
                runProgram(RUBBLE_CLI, QStringList{"simulate", project, "--steps", QString::number(steps)} + more);
            if (ended.exit != 0) qFatal("%s", qPrintable(ended.error));
            return resultOf(ended);
        };
        int saved = 0;
        for (int drawn = 0; saved < runs; ++drawn) {
            QVERIFY(drawn < 4 * runs);
            const RandomRun run = randomRun(drawn % 2 == 0 ? "arcade" : "dam", random);
            QVERIFY(saveProject(project.toStdString(), run.project));
            const int steps = 10 + static_cast<int>(random.below(120));
            if (!isCollapsing(after(steps, run.shots + QStringList{"--save-state", state}))) continue;
            ++saved;
            for (const int more : {1, 300}) {
                const QJsonObject whole = after(steps + more, run.shots), resumed = after(more, {"--state", state});
                QVERIFY(!whole["hash"].toString().isEmpty());
                QVERIFY2(resumed["hash"] == whole["hash"], QByteArray::number(drawn));
                QVERIFY2(resumed["bodies"] == whole["bodies"], QByteArray::number(drawn));
            }
        }
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
