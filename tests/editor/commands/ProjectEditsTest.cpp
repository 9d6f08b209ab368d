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
    void firstPatternReplacesTheSeedsOfANewAsset() {
        Document document(emptyProject());
        Addition added = addAsset(document.project(), "wall", {{rectangle({0, 0}, {3, 2}), {}}, 0.2});
        const Id wall = added.id;
        QVERIFY(document.push(std::move(added.edit)));
        const auto kindsAfter = [&](const LayerParameters& parameters) {
            document.push(addLayer(document.project(), wall, parameters).edit);
            std::string kinds;
            for (const PatternLayer& layer : findAsset(document.project(), wall)->pattern.layers)
                kinds += std::string(kindOf(layer.parameters).name) + ' ';
            document.undoStack().undo();
            return kinds;
        };
        QCOMPARE(kindsAfter(BrickBond{}), "bricks ");
        QCOMPARE(kindsAfter(BlueNoise{}), "blueNoise ");
        QCOMPARE(kindsAfter(LloydRelaxation{}), "uniform lloyd ");
        QCOMPARE(kindsAfter(UniformScatter{}), "uniform uniform ");
        QCOMPARE(kindsAfter(PlacedSeeds{}), "uniform placed ");
        QCOMPARE(kindsAfter(CrackLines{{{0, {{0.0, 1.0}, {3.0, 1.0}}}}}), "uniform strokes ");
        Asset edited = *findAsset(document.project(), wall);
        edited.pattern.layers[0].parameters = UniformScatter{.count = 21};
        document.push(modify("Set Count", edited));
        QCOMPARE(kindsAfter(BrickBond{}), "uniform bricks ");
    }
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
