// Tests app/cli/verbs/ClustersVerb.cpp.
#include "core/io/project/ProjectFile.h"
#include "core/structure/clusters/ClusterEditing.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace rubble;

class ClustersTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString file() const { return m_folder.filePath("arcade.rubble"); }
    Project project() const { return loadProject(file().toStdString()).value(); }
    ProgramOutcome clusters(const QStringList& arguments) const {
        return runProgram(RUBBLE_CLI, QStringList{"clusters", file(), "--asset", "arcade"} + arguments);
    }

private slots:
    void init() {
        QFile::remove(file());
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/arcade.rubble", file()));
        QVERIFY(QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner));
    }
    void levelsAreProposedAndSaved() {
        const ProgramOutcome coarse = clusters({"--count", "12"});
        QVERIFY2(coarse.exit == 0, qPrintable(coarse.error));
        QVERIFY2(coarse.output.startsWith("\"arcade\" has 12 clusters of level 0.\n"), qPrintable(coarse.output));
        QVERIFY2(clusters({"--level", "1", "--size", "4"}).exit == 0, "level 1");
        const Asset asset = project().assets[0];
        const Bake baked = bake(asset).value();
        std::set<FragmentPath> fragments;
        std::size_t fine = 0;
        for (const FragmentCluster& cluster : asset.bonding.clusters) {
            fine += cluster.level == 1 ? 1 : 0;
            if (cluster.level == 0) fragments.insert(cluster.fragments.begin(), cluster.fragments.end());
        }
        QCOMPARE(fragments.size(), std::size_t{baked.fragmentCount()});
        QVERIFY(fine > 80 && fine < 120);  // of 419 fragments
        QCOMPARE(runProgram(RUBBLE_CLI, {"check", file()}).exit, 0);
    }
    void wrongOnesAreRefused() {
        QVERIFY(clusters({"--count", "0"}).error.startsWith("There must be one cluster or more"));
        QCOMPARE(clusters({}).exit, 2);
        QCOMPARE(clusters({"--count", "3", "--size", "4"}).exit, 2);
        const ProgramOutcome whole = runProgram(
            RUBBLE_CLI, {"clusters", RUBBLE_SOURCE_DIR "/projects/house.rubble", "--asset", "front", "--count", "3"});
        QVERIFY(whole.exit == 1 && !whole.error.isEmpty());
        QVERIFY(project().assets[0].bonding.clusters.empty());
    }
};

RUBBLE_TEST(ClustersTest)
#include "ClustersTest.moc"
