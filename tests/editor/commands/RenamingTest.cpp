#include "editor/commands/Renaming.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

Project twoMaterials() {
    Project project;
    project.materials = {{.id = 1, .name = "stone"}, {.id = 2, .name = "brick"}};
    return project;
}

}  // namespace

class RenamingTest : public QObject {
    Q_OBJECT
private slots:
    void emptyAndTakenNamesHaveAFault() {
        QVERIFY(!nameFault(twoMaterials(), Part::Material, 1, "  ").isEmpty());
        QCOMPARE(nameFault(twoMaterials(), Part::Material, 1, " BRICK "), "The name \"brick\" is already taken.");
        QVERIFY(nameFault(twoMaterials(), Part::Material, 1, "Stone").isEmpty());  // its own, in another case
    }
    void renamingTrimsTheName() {
        Project project = twoMaterials();
        Edit edit = renameElement(project, Part::Material, 2, " tile ");
        applyEdit(project, edit);
        QCOMPARE(nameOf(project, Part::Material, 2), "tile");
    }
    void renamingChangesNoOtherName() {
        Project project = twoMaterials();
        project.assets = {{.id = 3, .name = "wall"}};
        project.instances = {{.id = 5, .name = "wall", .asset = 3}, {.id = 6, .name = "wall 2", .asset = 3}};
        Edit edit = renameElement(project, Part::Asset, 3, "side");
        applyEdit(project, edit);
        QCOMPARE(nameOf(project, Part::Asset, 3), "side");
        QCOMPARE(nameOf(project, Part::Instance, 5), "wall");
        QCOMPARE(nameOf(project, Part::Instance, 6), "wall 2");
        edit = renameElement(project, Part::Asset, 3, "wall");
        applyEdit(project, edit);
        edit = renameElement(project, Part::Instance, 5, "front");
        applyEdit(project, edit);
        QCOMPARE(nameOf(project, Part::Asset, 3), "wall");
        QCOMPARE(nameOf(project, Part::Instance, 6), "wall 2");
    }
    void missingElementHasNoName() { QVERIFY(nameOf(twoMaterials(), Part::Asset, 7).isEmpty()); }
};

RUBBLE_TEST(RenamingTest)
#include "RenamingTest.moc"
