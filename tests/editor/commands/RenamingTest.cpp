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
        swapInto(project, edit);
        QCOMPARE(nameOf(project, Part::Material, 2), "tile");
    }
    void missingElementHasNoName() { QVERIFY(nameOf(twoMaterials(), Part::Asset, 7).isEmpty()); }
};

RUBBLE_TEST(RenamingTest)
#include "RenamingTest.moc"
