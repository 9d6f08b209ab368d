// Tests app/cli/verbs/DamageVerb.cpp: what it writes, applies, merges and compares.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

QString demoPath(const char* name) { return QString(RUBBLE_SOURCE_DIR "/projects/") + name + ".rubble"; }

}  // namespace

class DamageTest : public QObject {
    Q_OBJECT

    QString pathOf(const QString& name) const { return m_folder.filePath(name); }
    ProgramOutcome damage(const QStringList& arguments) const {
        return runProgram(RUBBLE_CLI, QStringList{"damage"} + arguments);
    }
    /// Simulates a demo with one of its shots and saves its state.
    void simulate(const char* demo, const char* shot, const QString& state) {
        const ProgramOutcome played = runProgram(RUBBLE_CLI, {"simulate", demoPath(demo), "--steps", "90", "--shot",
                                                              shot, "--save-state", pathOf(state), "--quiet"});
        QVERIFY2(played.exit == 0, qPrintable(played.error));
    }
    /// Writes the damage of an instance. Returns what is printed.
    nlohmann::json write(const char* demo, const QString& state, const QString& instance, const QString& file) {
        QStringList arguments{"write", "--project", demoPath(demo), "--instance", instance, "--out", pathOf(file)};
        if (!state.isEmpty()) arguments += {"--state", pathOf(state)};
        const ProgramOutcome written = damage(arguments);
        if (written.exit != 0) qFatal("%s", qPrintable(written.error));
        return nlohmann::json::parse(written.output.toStdString());
    }
    QByteArray bytes(const QString& file) const { return bytesOfFile(pathOf(file)); }

    QTemporaryDir m_folder;

private slots:
    void appliedDamagesAreWrittenAgain_data() {
        QTest::addColumn<QByteArray>("demo");
        QTest::addColumn<QByteArray>("shot");
        QTest::newRow("bonded") << QByteArray("arcade") << QByteArray("blast at a pier");
        QTest::newRow("mortar") << QByteArray("two-storey-house") << QByteArray("ball at the front wall");
        QTest::newRow("whole") << QByteArray("house") << QByteArray("box at the door");
    }
    void appliedDamagesAreWrittenAgain() {
        QFETCH(const QByteArray, demo);
        QFETCH(const QByteArray, shot);
        simulate(demo.constData(), shot.constData(), "hit.rubblestate");
        const Result<Project> project = loadProject(demoPath(demo.constData()).toStdString());
        QStringList apply{"apply", "--project", demoPath(demo.constData()), "--out", pathOf("again.rubblestate")};
        int damaged = 0;
        std::vector<QString> names;
        for (const Instance& instance : project->instances) {
            const QString name = QString::fromStdString(instance.name), file = name + ".rubbledamage";
            const nlohmann::json written = write(demo.constData(), "hit.rubblestate", name, file);
            damaged += written["broken"].get<int>() > 0 ? 1 : 0;
            QVERIFY(bytes(file).size() <=
                    64 + (written["count"].get<int>() + 7) / 8 + 4 * written["weakened"].get<int>());
            if (written["broken"].get<int>() + written["weakened"].get<int>() == 0) continue;
            apply += {"--instance", name, pathOf(file)};
            names.push_back(name);
        }
        QVERIFY(damaged > 0);
        const ProgramOutcome applied = damage(apply);
        QVERIFY2(applied.exit == 0, qPrintable(applied.error));
        for (const QString& name : names) {
            write(demo.constData(), "again.rubblestate", name, "again.rubbledamage");
            QVERIFY2(bytes("again.rubbledamage") == bytes(name + ".rubbledamage"), qPrintable(name));
        }
    }
    void mergedIsWhatIsBrokenInOneOfThem() {
        simulate("arcade", "blast at a pier", "one.rubblestate");
        simulate("arcade", "ball at a spandrel", "other.rubblestate");
        const nlohmann::json one = write("arcade", "one.rubblestate", "arcade", "one"),
                             other = write("arcade", "other.rubblestate", "arcade", "other");
        write("arcade", {}, "arcade", "intact");
        const ProgramOutcome merged =
            damage({"merge", pathOf("one"), pathOf("other"), pathOf("intact"), "--out", pathOf("both")});
        QVERIFY2(merged.exit == 0, qPrintable(merged.error));
        const nlohmann::json both = nlohmann::json::parse(merged.output.toStdString());
        QVERIFY(both["broken"].get<int>() >= std::max(one["broken"].get<int>(), other["broken"].get<int>()));
        QCOMPARE(damage({"merge", pathOf("other"), pathOf("one"), pathOf("one"), "--out", pathOf("again")}).exit, 0);
        QVERIFY(bytes("both") == bytes("again"));

        const ProgramOutcome same = damage({"compare", pathOf("both"), pathOf("again")});
        QCOMPARE(same.exit, 0);
        QCOMPARE(nlohmann::json::parse(same.output.toStdString())["broken"].get<int>(), 0);
        const ProgramOutcome added = damage({"compare", pathOf("intact"), pathOf("one"), "--out", pathOf("added")});
        QCOMPARE(added.exit, 3);
        QCOMPARE(added.error, QString("The damages differ.\n"));
        QVERIFY(bytes("added") == bytes("one"));
        // What one has beyond the other, merged into it, is both.
        QCOMPARE(damage({"compare", pathOf("other"), pathOf("both"), "--out", pathOf("beyond")}).exit, 3);
        QCOMPARE(damage({"merge", pathOf("beyond"), pathOf("other"), "--out", pathOf("joined")}).exit, 0);
        QVERIFY(bytes("joined") == bytes("both"));
    }
    void wrongFilesAreRefused() {
        write("arcade", {}, "arcade", "arcade");
        write("house", {}, "front 1.1", "front");
        const auto fault = [&](const QStringList& arguments) { return damage(arguments).error; };
        QVERIFY(fault({"merge", pathOf("arcade"), pathOf("front"), "--out", pathOf("neither")}).contains("front"));
        QVERIFY(!QFile::exists(pathOf("neither")));
        const QString applied = fault({"apply", pathOf("front"), "--project", demoPath("arcade"), "--instance",
                                       "arcade", "--out", pathOf("state")});
        QVERIFY2(applied.contains("arcade"), qPrintable(applied));
        QVERIFY(!QFile::exists(pathOf("state")));
        QFile file(pathOf("arcade"));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(30) && file.write("x") == 1);
        file.close();
        QVERIFY(fault({"compare", pathOf("arcade"), pathOf("arcade")}).contains("arcade"));
        QCOMPARE(fault({"write", "--project", demoPath("house"), "--instance", "roof", "--out", "-"}).left(40),
                 QString("The project has no instance \"roof\"; it h"));
    }
    void optionsThatDoNotFitAreErrorsOfUsage() {
        const auto fault = [&](const QStringList& arguments, const QString& sentence) {
            const auto run = damage(arguments);
            QCOMPARE(run.error.trimmed(), sentence + "; see rubble-cli damage --help.");
            QCOMPARE(run.exit, 2);
        };
        fault({"merge", "a", "--out", "b", "--project", "c"}, "merge does not take --project");
        fault({"write", "--out", "b"}, "write needs --project");
        fault({"compare", "a"}, "compare takes two files");
        fault({"apply", "a", "--project", "c", "--out", "b"},
              "apply takes a FILE for each --instance, in the same order");
        fault({"merge", "a"}, "merge needs --out");
    }
};

RUBBLE_TEST(DamageTest)
#include "DamageTest.moc"
