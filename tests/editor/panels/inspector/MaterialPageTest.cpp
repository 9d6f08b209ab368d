#include "editor/panels/inspector/MaterialPage.h"

#include "editor/widgets/SliderField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QStyle>

using namespace rubble;
using test::InspectorDesk;

namespace {

/// Drags a slider's handle to its right end.
void drag(QSlider& slider) {
    constexpr int kHalfHandle = 6;
    const int middle = slider.height() / 2;
    const int from = kHalfHandle + QStyle::sliderPositionFromValue(slider.minimum(), slider.maximum(), slider.value(),
                                                                   slider.width() - 2 * kHalfHandle);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {from, middle});
    for (int x = from; x < slider.width(); x += 5) QTest::mouseMove(&slider, {x, middle});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {slider.width() - 2, middle});
}

}  // namespace

class MaterialPageTest : public QObject {
    Q_OBJECT
private slots:
    void sliderDragIsOneUndoStep() {
        InspectorDesk desk;
        desk.selection.setMaterial(1);
        drag(desk.control<SliderField>("Friction").slider());
        QVERIFY(findMaterial(desk.document.project(), 1)->friction > 1.0);
        QCOMPARE(desk.document.undoStack().count(), 1);
        drag(desk.control<SliderField>("Density").slider());
        QCOMPARE(desk.document.undoStack().count(), 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(MaterialPageTest, QApplication)
#include "MaterialPageTest.moc"
