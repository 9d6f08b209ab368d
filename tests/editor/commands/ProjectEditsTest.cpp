#include "editor/commands/ProjectEdits.h"

#include "core/asset/strength/Threshold.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/BondedProject.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/editor/EditedProject.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

const Prism kPane{{rectangle({0.0, 0.0}, {1.0, 1.0}), {}}, 0.008};

Project projectOf(const Material& material) {
    Project project;
    test::addMaterial(project, material);
    return project;
}

Project withPane(const Project& project) { return test::editedProject(project, addAsset(project, "pane", kPane).edit); }

}  // namespace

class ProjectEditsTest : public QObject {
    Q_OBJECT
private slots:
    void mortarsLoseDeletedInstances() {
        Project before = bondedProject();  // mortar 30 of the instances 10 and 11, mortar 31 of all
        before.instances.push_back({.id = 12, .name = "lintel", .asset = 2});
        before.mortars[0].instances = {10, 11, 12};
        const Project fewer = test::editedProject(before, removeInstances(before, std::vector<Id>{11}));
        QCOMPARE(fewer.mortars.size(), std::size_t{2});
        QCOMPARE(fewer.mortars[0].instances, (std::vector<Id>{10, 12}));
        QVERIFY(fewer.mortars[1] == before.mortars[1]);
    }
    void mortarOfDeletedInstancesAloneIsDeleted() {
        const Project before = bondedProject();
        const Project none = test::editedProject(before, removeInstances(before, std::vector<Id>{10, 11}));
        QCOMPARE(none.mortars, std::vector<Mortar>{before.mortars[1]});
        const Project empty = test::editedProject(before, removeAssets(before, std::vector<Id>{2}));
        QCOMPARE(empty.mortars, std::vector<Mortar>{before.mortars[1]});
    }
    void editsBetweenProjectsHaveTheirMortars() {
        const Project before = bondedProject();
        Project after = before;
        after.mortars.erase(after.mortars.begin());
        after.mortars[0].tolerance = 0.25;
        after.mortars.push_back({.id = 32, .name = "more"});
        QCOMPARE(test::editedProject(before, editBetween("Edit", before, after)).mortars, after.mortars);
    }
    void newAssetsDeriveTheirThresholdWhereTheStrengthIsKnown() {
        const Project glass =
            withPane(projectOf({.name = "glass", .density = 2500.0, .tensileStrength = 4.5e7, .youngsModulus = 7e10}));
        QVERIFY(thresholdOf(glass, glass.assets[0]) < 1.0);
        const Project unknown = withPane(projectOf({.name = "jelly"}));
        QVERIFY(!unknown.assets[0].contactTime);
        QCOMPARE(thresholdOf(unknown, unknown.assets[0]), 100.0);
    }
};

RUBBLE_TEST_WITH(ProjectEditsTest, QCoreApplication)
#include "ProjectEditsTest.moc"
