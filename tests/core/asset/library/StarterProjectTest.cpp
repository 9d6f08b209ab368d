#include "core/asset/library/StarterProject.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyProject.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class StarterProjectTest : public QObject {
    Q_OBJECT
private slots:
    void bothProjectsAreValid() {
        QCOMPARE(verifyProject(emptyProject()).value_or(""), std::string());
        QCOMPARE(verifyProject(starterProject()).value_or(""), std::string());
    }
    void emptyProjectHasOneMaterial() {
        const Project project = emptyProject();
        QCOMPARE(project.materials.size(), std::size_t{1});
        QVERIFY(project.assets.empty() && project.instances.empty());
    }
    void wallBreaksIntoTwentyFragments() {
        const Project project = starterProject();
        QCOMPARE(project.assets[0].name, std::string("wall"));
        QCOMPARE(bake(project.assets[0])->fragmentCount(), 20u);
    }
    void wallStandsOnTheGround() {
        const Project project = starterProject();
        const double bottom = boundsOf(project.assets[0].prism().outline.outer).min.y;
        QCOMPARE(project.instances[0].pose.position.y + bottom, project.ground.height);
    }
};

RUBBLE_TEST(StarterProjectTest)
#include "StarterProjectTest.moc"
