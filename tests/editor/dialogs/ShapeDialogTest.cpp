#include "editor/dialogs/ShapeDialog.h"

#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"

#include <QApplication>

using namespace rubble;

class ShapeDialogTest : public QObject {
    Q_OBJECT
private slots:
    void lengthsAreInMetresWhateverTheUnit() {
        ShapeDialog dialog("Add Rectangle", {{"&Width:", 1.0}, {"&Height:", 0.5}}, {LengthUnit::Centimetre}, nullptr);
        QCOMPARE(dialog.length(1), 0.5);
        NumberField* height = dialog.findChildren<NumberField*>()[1];
        QVERIFY2(height->text().endsWith("cm"), qPrintable(height->text()));
        height->selectAll();
        QTest::keyClicks(height, "75");
        dialog.accept();
        QCOMPARE(dialog.length(1), 0.75);
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    }
    void cornersAreWholeNumbersFromThree() {
        ShapeDialog dialog("Add Polygon", {{"D&iameter:", 1.0}}, {}, nullptr);
        dialog.addCorners(6);
        QCOMPARE(dialog.corners(), 6);
        const FieldRange& range = dialog.findChildren<NumberField*>()[1]->range();
        QVERIFY(range.contains(3.0) && !range.contains(2.0) && !range.contains(3.5));
    }
    void refusedTextKeepsItOpen() {
        ShapeDialog dialog("Add Rectangle", {{"&Width:", 1.0}}, {}, nullptr);
        dialog.show();
        NumberField* width = dialog.findChild<NumberField*>();
        width->selectAll();
        QTest::keyClicks(width, "0");
        dialog.accept();
        QVERIFY(dialog.isVisible());
        QCOMPARE(dialog.length(0), 1.0);
    }
};

RUBBLE_TEST_WITH(ShapeDialogTest, QApplication)
#include "ShapeDialogTest.moc"
