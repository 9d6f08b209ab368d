#include "editor/panels/inspector/MaterialPage.h"

#include "editor/widgets/SliderField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

using namespace rubble;
using test::InspectorDesk;

class MaterialPageTest : public QObject {
    Q_OBJECT
private slots:
    void sliderDragIsOneUndoStep() {
        InspectorDesk desk;
        desk.selection.setMaterial(1);
        test::drag(desk.control<SliderField>("Friction").slider());
        QVERIFY(findMaterial(desk.document.project(), 1)->friction > 1.0);
        QCOMPARE(desk.document.undoStack().count(), 1);
        test::drag(desk.control<SliderField>("Density").slider());
        QCOMPARE(desk.document.undoStack().count(), 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(MaterialPageTest, QApplication)
#include "MaterialPageTest.moc"
