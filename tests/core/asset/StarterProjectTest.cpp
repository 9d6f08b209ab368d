#include "core/asset/StarterProject.h"

#include "core/asset/Bake.h"

#include <QTest>

using namespace rubble;

class StarterProjectTest : public QObject {
    Q_OBJECT
private slots:
    void bothAreValid() {
        QCOMPARE(verifyProject(emptyProject()).value_or(""), std::string());
        QCOMPARE(verifyProject(starterProject()).value_or(""), std::string());
    }
    void theEmptyOneHasAMaterialOnly() {
        const Project project = emptyProject();
        QCOMPARE(project.materials.size(), std::size_t{1});
        QVERIFY(project.assets.empty() && project.instances.empty());
    }
    void theWallBreaksIntoTwenty() {
        const Project project = starterProject();
        QCOMPARE(project.assets[0].name, std::string("wall"));
        QCOMPARE(bake(project.assets[0])->fragmentCount(), 20u);
    }
    void theWallStandsOnTheGround() {
        const Project project = starterProject();
        const double bottom = boundsOf(project.assets[0].prism.outline.outer).min.y;
        QCOMPARE(project.instances[0].pose.position.y + bottom, project.ground.height);
    }
};

QTEST_APPLESS_MAIN(StarterProjectTest)
#include "StarterProjectTest.moc"
