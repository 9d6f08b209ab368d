#include "editor/commands/ProjectEdits.h"

#include "core/asset/strength/Threshold.h"
#include "tests/support/TestProgram.h"
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
