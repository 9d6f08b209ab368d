#include "core/asset/project/Ids.h"

#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"

#include <limits>

using namespace rubble;

class IdsTest : public QObject {
    Q_OBJECT
private slots:
    void nextIdAdvances() {
        Project project = starterProject();
        const Id next = project.nextId;
        QCOMPARE(allocateId(project), next);
        QCOMPARE(project.nextId, next + 1);
    }
    void unusedIdsAreBetweenThoseOfElementsAndLayers() {
        Project project = emptyProject();
        project.materials = {{.id = 1}, {.id = 3}};
        project.assets = {{.id = 4}};
        project.assets[0].pattern.layers = {{.id = 6}};
        project.assets[0].levels = {{.pattern = {{{.id = 7}}}}};
        project.shots = {{.id = 9}};
        project.mortars = {{.id = 10}};
        QCOMPARE(lowestUnusedId(project), Id{2});
        QCOMPARE(lowestUnusedId(project, 2), Id{5});
        QCOMPARE(lowestUnusedId(project, 5), Id{8});
        QCOMPARE(lowestUnusedId(project, 8), Id{11});
    }
    void greatestNextIdReusesIds() {
        Project project = emptyProject();
        project.materials = {{.id = 1}};
        project.nextId = std::numeric_limits<Id>::max();
        QCOMPARE(allocateId(project), Id{2});
        QCOMPARE(project.nextId, std::numeric_limits<Id>::max());
    }
};

RUBBLE_TEST(IdsTest)
#include "IdsTest.moc"
