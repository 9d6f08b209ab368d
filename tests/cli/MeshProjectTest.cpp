// Tests what the command line does with projects that have meshes: app/cli/verbs/SimulateVerb.cpp,
// app/cli/verbs/DiffVerb.cpp and core/io/project/MeshFolder.cpp.
#include "app/cli/Cli.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class MeshProjectTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    QString pathOf(const char* name) const { return m_folder->filePath(name); }
    void save(const char* name, const Project& project) const {
        QVERIFY(saveProject(pathOf(name).toStdString(), project));
    }

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        save("house.rubble", test::meshProject());
    }
    void filesOfProjectsAreChecked() {
        const ProgramOutcome outcome = runProgram(RUBBLE_CLI, {"check", pathOf("house.rubble")});
        QVERIFY2(outcome.exit == 0, qPrintable(outcome.output + outcome.error));
    }
    void missingMeshesAreNamed() {
        QVERIFY(QDir(pathOf("house.rubble.meshes")).removeRecursively());
        const QStringList verbs[] = {{"check"}, {"simulate", "--steps", "1"}, {"draw"}};
        for (const QStringList& verb : verbs) {
            const ProgramOutcome outcome = runProgram(RUBBLE_CLI, verb + QStringList{pathOf("house.rubble")});
            QVERIFY2(outcome.exit != 0, qPrintable(verb[0]));
            const QString all = outcome.output + outcome.error;
            QVERIFY2(all.contains("Asset \"sculpture\": The file of its mesh is missing, \""), qPrintable(all));
        }
    }
    void otherMeshesDiffer() {
        save("other.rubble", test::meshProject(test::torus(8, 6)));
        const ProgramOutcome outcome =
            runProgram(RUBBLE_CLI, {"diff", pathOf("house.rubble"), pathOf("other.rubble"), "--asset", "sculpture"});
        QVERIFY2(outcome.exit == 3, qPrintable(outcome.error));
        QVERIFY2(outcome.output.startsWith("sculpture: changed\n  mesh: 96 triangles, "), qPrintable(outcome.output));
        QVERIFY2(outcome.output.contains(", was 60 triangles, "), qPrintable(outcome.output));
        QCOMPARE(runProgram(RUBBLE_CLI, {"diff", pathOf("house.rubble"), pathOf("house.rubble")}).exit, 0);
    }
    void textsAreSimulatedWithoutMeshesOnly() {
        const auto simulated = [&](const QString& input) {
            const QString program = RUBBLE_CLI;
            return runProgram("sh", {"-c", "'" + program + "' simulate " + input + " --steps 1"});
        };
        const ProgramOutcome file = simulated(pathOf("house.rubble"));
        QVERIFY2(file.exit == 0, qPrintable(file.error));
        const ProgramOutcome text = simulated("- < " + pathOf("house.rubble"));
        QCOMPARE(text.exit, kExitError);
        QCOMPARE(text.error, QString("Asset \"sculpture\": Its mesh lies in a folder beside the project's "
                                     "file; give the file, not its text.\n"));
    }
};

RUBBLE_TEST(MeshProjectTest)
#include "MeshProjectTest.moc"
