#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Arcade.h"
#include "tests/support/asset/Dam.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Pane.h"
#include "tests/support/asset/RockFace.h"
#include "tests/support/asset/Sculptures.h"
#include "tests/support/asset/TwoStoreyHouse.h"
#include "tests/support/asset/WallWithOpenings.h"

#include <QTest>

using namespace rubble;

/// The demo projects in projects/ are what their builders in tests/support/ build. RUBBLE_UPDATE_PROJECTS=1 writes
/// them.
class ProjectFilesTest : public QObject {
    Q_OBJECT
private slots:
    void filesMatchTheBuiltProjects_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<Project>("built");
        QTest::newRow("arcade") << "arcade.rubble" << test::arcade();
        QTest::newRow("dam") << "dam.rubble" << test::dam();
        QTest::newRow("house") << "house.rubble" << test::house();
        QTest::newRow("joined house") << "joined-house.rubble" << test::joinedHouse();
        QTest::newRow("pane") << "pane.rubble" << test::pane();
        QTest::newRow("rock face") << "rock-face.rubble" << test::rockFace();
        QTest::newRow("sculptures") << "sculptures.rubble" << test::sculptures();
        QTest::newRow("two-storey house") << "two-storey-house.rubble" << test::twoStoreyHouse();
        QTest::newRow("wall with openings") << "wall-with-openings.rubble" << test::wallWithOpenings();
    }
    void filesMatchTheBuiltProjects() {
        QFETCH(QString, name);
        QFETCH(Project, built);
        const std::string path = RUBBLE_SOURCE_DIR "/projects/" + name.toStdString();
        if (qEnvironmentVariableIsSet("RUBBLE_UPDATE_PROJECTS")) QVERIFY(saveProject(path, built).hasValue());
        const Result<std::string> text = readFile(path);
        QVERIFY2(text.hasValue(), path.c_str());
        QCOMPARE(QString::fromStdString(*text), QString::fromStdString(projectText(built)));
        const Result<Project> loaded = loadProject(path);
        QVERIFY(loaded.hasValue() && *loaded == built);
    }

    void paneBreaksInto200() {
        const Project project = test::pane();
        const Result<Bake> baked = bake(project.assets[0]);
        QVERIFY(baked.hasValue());
        QCOMPARE(baked->fragmentCount(), 200u);
        QCOMPARE(baked->diagnostics.size(), std::size_t{0});
        QCOMPARE(verifyBake(*baked, project.assets[0]).value_or(""), std::string());
    }
    void wallWithOpeningsBreaksTwice() {
        const Project project = test::wallWithOpenings();
        const Result<Bake> baked = bake(project.assets[0]);
        QVERIFY(baked.hasValue());
        QCOMPARE(verifyBake(*baked, project.assets[0]).value_or(""), std::string());
        QVERIFY(baked->fractures[0].seeds.positions.size() == 60 && baked->fractures.back().level == 1);
        // 4 x 2.6 m less door and window, 0.24 m thick.
        QCOMPARE(baked->whole.volume, (4.0 * 2.6 - 0.9 * 2.05 - 1.2 * 1.15) * 0.24);
    }
};

RUBBLE_TEST(ProjectFilesTest)
#include "ProjectFilesTest.moc"
