#include "editor/panels/inspector/ScenePage.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

using namespace rubble;
using test::InspectorDesk;

class ScenePageTest : public QObject {
    Q_OBJECT
private slots:
    void sceneSettingsAreEdited() {
        InspectorDesk desk;
        desk.selection.setSubject(Part::Scene);
        desk.type("Gravity along y", "-3.7");
        QCOMPARE(desk.document.project().gravity.y, -3.7);
        desk.type("Least energy", "2 kJ");
        desk.type("Events per step", "40");
        QVERIFY((desk.document.project().events == EventSettings{.leastEnergy = 2000.0, .maxRecords = 40}));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(ScenePageTest, QApplication)
#include "ScenePageTest.moc"
