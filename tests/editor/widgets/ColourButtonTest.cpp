#include "editor/widgets/ColourButton.h"

#include "editor/widgets/ColourConversion.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QColorDialog>
#include <QSignalSpy>

using namespace rubble;

class ColourButtonTest : public QObject {
    Q_OBJECT
private slots:
    void showsItsColourOrThatTheyDiffer() {
        ColourButton button;
        button.setValue(fromQColor(QColor(255, 0, 0)));
        QCOMPARE(button.text(), "#FF0000");
        button.setMixed();
        QCOMPARE(button.text(), "Mixed");
    }
    void swatchHasTheColour() {
        const QImage swatch = swatchIcon(fromQColor(QColor(0, 0, 255))).pixmap(16).toImage();
        QCOMPARE(swatch.pixelColor(swatch.rect().center()), QColor(0, 0, 255));
    }
    void pickedColoursAreOneStepThatCancelUndoes() {
        ColourButton button;
        const Colour before = fromQColor(QColor(10, 20, 30));
        button.setValue(before);
        const QSignalSpy started(&button, &ColourButton::editingStarted), edited(&button, &ColourButton::edited);
        button.click();
        auto* dialog = button.findChild<QColorDialog*>();
        QVERIFY(dialog);
        dialog->setCurrentColor(QColor(200, 0, 0));
        dialog->setCurrentColor(QColor(0, 200, 0));
        QCOMPARE(started.count(), 1);
        QCOMPARE(edited.count(), 2);
        QCOMPARE(toQColor(button.value()), QColor(0, 200, 0));
        dialog->reject();
        QCOMPARE(edited.count(), 3);
        QCOMPARE(button.value(), before);
    }
};

RUBBLE_TEST_WITH(ColourButtonTest, QApplication)
#include "ColourButtonTest.moc"
