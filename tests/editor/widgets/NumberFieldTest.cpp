// Tests editor/widgets/NumberField.cpp, editor/widgets/RandomSeedField.cpp, editor/widgets/SliderField.cpp,
// editor/widgets/TypedFields.cpp and editor/widgets/numbers/NumberText.cpp.
#include "editor/widgets/RandomSeedField.h"
#include "editor/widgets/SliderField.h"
#include "editor/widgets/TypedFields.h"
#include "tests/support/TestProgram.h"

#include <QDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace rubble;

namespace {

const NumberFormat kMetres = Units().lengths();
const NumberFormat kCentimetres = Units{LengthUnit::Centimetre}.lengths();
const QLocale kGerman(QLocale::German, QLocale::Germany);
const QString kNbsp(QChar(QChar::Nbsp));

/// A field in a window whose focus is on another widget.
struct Window : QWidget {
    NumberField field{this};
    QLineEdit other{this};
    QSignalSpy edits{&field, &NumberField::edited};
    QSignalSpy starts{&field, &NumberField::editingStarted};
    QSignalSpy refusals{&field, &NumberField::refused};

    Window() {
        field.move(0, 40);
        show();
        activateWindow();
        if (!QTest::qWaitForWindowActive(this, kPatience)) qFatal("The window does not become active.");
        other.setFocus();
    }
    void type(const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    QLineEdit& line() { return *field.findChild<QLineEdit*>(); }
};

/// True if the field's frame is red in the middle of its upper edge.
bool isRed(QWidget& field) {
    const QColor frame = field.grab().toImage().pixelColor(field.width() / 2, 1);
    return frame.red() > 2 * frame.green() && frame.red() > 2 * frame.blue();
}

void wheel(QWidget& widget, int steps) {
    const QPointF middle = QRectF(widget.rect()).center();
    QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace

class NumberFieldTest : public QObject {
    Q_OBJECT
private slots:
    void exactTextsReadBackBitForBit_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("metres");
        QTest::addColumn<QString>("centimetres");
        QTest::newRow("zero") << 0.0 << "0"
                              << "0";
        QTest::newRow("no rounding by the change of unit") << 0.07 << "0.07"
                                                           << "7";
        QTest::newRow("all digits") << 0.1 + 0.2 << "0.30000000000000004"
                                    << "30.000000000000004";
        QTest::newRow("negative") << -12.5 << "-12.5"
                                  << "-1250";
        QTest::newRow("tiny") << 1.5e-10 << "1.5e-10"
                              << "1.5e-8";
        QTest::newRow("huge") << 3e22 << "3e22"
                              << "3e24";
        QTest::newRow("large") << 123456789.0 << "123456789"
                               << "12345678900";
    }
    void exactTextsReadBackBitForBit() {
        QFETCH(double, value);
        QFETCH(QString, metres);
        QFETCH(QString, centimetres);
        QCOMPARE(exactText(value, kMetres, QLocale::c()), metres);
        QCOMPARE(exactText(value, kCentimetres, QLocale::c()), centimetres);
        for (const NumberFormat& format : {kMetres, kCentimetres}) {
            for (const QLocale& locale : {QLocale::c(), kGerman, QLocale(QLocale::Arabic, QLocale::Egypt)}) {
                const std::optional<double> back = parseNumber(exactText(value, format, locale), format, locale);
                QVERIFY(back && *back == value);
            }
        }
    }
    void malformedNumbersAreRejected() {
        for (const char* text : {"", "m", "1.2.3", "1,5", "nan", "inf", "1e999", "0x10", "--1", "1 2", "e5"}) {
            QVERIFY2(!parseNumber(text, kMetres, QLocale::c()), text);
        }
        QCOMPARE(parseNumber("1,5", kMetres, kGerman).value(), 1.5);
        QVERIFY(!parseNumber("1.5", kMetres, kGerman));  // a thousands separator in German
    }
    void typingEmitsEditedOnce() {
        Window window;
        window.field.setLocale(kGerman);
        window.field.setFormat(kCentimetres);
        window.type("12,5");
        QCOMPARE(window.edits.count(), 1);
        QCOMPARE(window.starts.count(), 1);
        QCOMPARE(window.field.value(), 0.125);
        QCOMPARE(window.line().text(), "12,5" + kNbsp + "cm");
        window.type("12,5");
        QCOMPARE(window.edits.count(), 1);  // unchanged
    }
    /// A metre has 17 digits in feet.
    void withoutFocusANumberIsRoundedInItsUnit() {
        Window window;
        window.field.setFormat(Units{LengthUnit::Foot}.lengths());
        window.field.setValue(1.0);
        QCOMPARE(window.line().text(), "3.2808" + kNbsp + "ft");
        QVERIFY(window.field.toolTip().contains("3.28083989501312"));
        window.field.setFocus();
        QVERIFY(window.line().text().startsWith("3.28083989501312"));
        window.other.setFocus();
        QCOMPARE(window.line().text(), "3.2808" + kNbsp + "ft");
        QCOMPARE(window.field.value(), 1.0);
        QCOMPARE(window.edits.count(), 0);
    }
    void focusOutAppliesTheTypedNumber() {
        Window window;
        window.field.setFocus();
        window.field.selectAll();
        QTest::keyClicks(&window.field, "3");
        QCOMPARE(window.edits.count(), 0);
        QTest::keyClick(&window.field, Qt::Key_Tab);
        QCOMPARE(window.field.value(), 3.0);
        QCOMPARE(window.edits.count(), 1);
    }
    void narrowestFieldShowsAllDigitsAndTheUnit() {
        Window window;
        window.field.setFormat(Units::impulses());
        window.field.setValue(0.11072);
        window.field.resize(window.field.minimumSizeHint());
        constexpr int kMargin = 4;  // of Qt's line control, left and right of the text
        QCOMPARE(window.line().text(), "0.11072" + kNbsp + "N·s");
        const int room = window.line().contentsRect().width() - kMargin;
        const int need = window.line().fontMetrics().horizontalAdvance(window.line().text());
        QVERIFY2(need <= room, qPrintable(QString("%1 of %2").arg(room).arg(need)));
    }
    void showingANumberKeepsAllItsDigits() {
        Window window;
        window.field.setFormat(kMetres);
        window.field.setValue(1.0 / 3.0);
        QCOMPARE(window.line().text(), "0.33333" + kNbsp + "m");
        QVERIFY(window.field.toolTip().contains("0.3333333333333333"));
        window.field.setFocus();
        QCOMPARE(window.line().text(), "0.3333333333333333" + kNbsp + "m");
        QTest::keyClick(&window.field, Qt::Key_Return);
        window.other.setFocus();
        QCOMPARE(window.field.value(), 1.0 / 3.0);
        QCOMPARE(window.edits.count(), 0);
    }
    void invalidInputIsRefusedWithAMessage() {
        Window window;
        window.field.setValue(2.0);
        window.field.setRange(FieldRange::aboveZero());
        for (const char* text : {"abc", "0", "-1", "1e999"}) window.type(text);
        QCOMPARE(window.edits.count(), 0);
        QCOMPARE(window.refusals.count(), 4);
        QCOMPARE(window.refusals[0][0], "\"abc\" is not a number. Enter a number such as 12.5.");
        QCOMPARE(window.refusals[1][0], "Enter a number above 0.");
        QCOMPARE(window.field.value(), 2.0);
        window.field.setRange(FieldRange::whole(1, 10));
        window.type("2.5");
        QCOMPARE(window.refusals.last()[0], "Enter a whole number from 1 to 10.");
    }
    void unknownUnitIsRefusedWithAMessage() {
        Window window;
        window.field.setFormat(kMetres);
        window.type("8 furlongs");
        QCOMPARE(window.refusals.last()[0],
                 "\"8 furlongs\" is not a number with a unit that this field knows. Enter a number such as "
                 "12.5\u00a0m; units: m, cm, mm, µm, dm, km, ft, in, yd.");
        QCOMPARE(window.edits.count(), 0);
    }
    void refusedTextStaysAndSaysWhatIsWrong() {
        Window window;
        window.field.setFormat(Units::masses());
        window.field.setValue(2.0);
        window.field.setFocus();
        window.field.selectAll();
        QTest::keyClicks(&window.field, "50 q");
        QTest::keyClick(&window.field, Qt::Key_Tab);
        QVERIFY(!window.field.hasFocus());
        QCOMPARE(window.refusals.count(), 1);
        QCOMPARE(window.line().text(), "50 q");
        QCOMPARE(window.field.refusal(), window.refusals[0][0].toString());
        QCOMPARE(window.field.toolTip(), window.field.refusal());
        QVERIFY(isRed(window.field));
        window.field.setValue(2.0);  // as panels do after each edit
        window.field.setFormat(Units::masses());
        QCOMPARE(window.line().text(), "50 q");
        window.type("50 g");
        QCOMPARE(window.field.value(), 0.05);
        QVERIFY(window.field.refusal().isEmpty());
        QVERIFY(!isRed(window.field));
    }
    void refusedTextIsDiscardedWithEscapeOrAnotherValue() {
        Window window;
        window.type("q");
        QVERIFY(!window.field.refusal().isEmpty());
        QTest::keyClick(&window.field, Qt::Key_Escape);
        QVERIFY(window.field.refusal().isEmpty());
        QCOMPARE(window.line().text(), "0");
        window.type("q");
        window.field.setValue(3.0);
        QVERIFY(window.field.refusal().isEmpty());
        QCOMPARE(window.line().text(), "3");
        window.type("q");
        discardTyping(window);
        QCOMPARE(window.line().text(), "3");
    }
    void numberThatItsUserRefusesStaysAsText() {
        Window window;
        connect(&window.field, &NumberField::edited, &window, [&] {
            window.field.setValue(0.0);
            window.field.refuseEntered("Too wide.");
        });
        window.type("7");
        QCOMPARE(window.line().text(), "7");
        QCOMPARE(window.field.toolTip(), "Too wide.");
        window.other.setFocus();
        QCOMPARE(window.line().text(), "7");
    }
    void randomSeedThatIsRefusedStays() {
        QWidget window;
        RandomSeedField field(&window);
        QSignalSpy refusals(&field, &RandomSeedField::refused);
        field.setValue(3);
        field.line().setText("dice");
        field.line().setModified(true);
        QVERIFY(!field.commit());
        QCOMPARE(refusals.count(), 1);
        field.setValue(3);  // as panels do after each edit
        QCOMPARE(field.line().text(), "dice");
        QCOMPARE(field.line().accessibleDescription(), refusals[0][0].toString());
        QVERIFY(!commitFields(window));
        discardTyping(window);
        QCOMPARE(field.line().text(), "3");
    }
    void dialogStaysOpenWhileATextIsRefused() {
        QDialog dialog;
        auto* field = new NumberField(&dialog);
        field->setFormat(kMetres);
        QVERIFY(commitFields(dialog));
        field->findChild<QLineEdit*>()->setText("8 furlongs");
        field->findChild<QLineEdit*>()->setModified(true);
        QVERIFY(!commitFields(dialog));
        field->findChild<QLineEdit*>()->setText("8mm");
        field->findChild<QLineEdit*>()->setModified(true);
        QVERIFY(commitFields(dialog));
        QCOMPARE(field->value(), 0.008);
    }
    void escapeDiscardsTyping() {
        Window window;
        window.field.setValue(2.0);
        window.field.setFocus();
        QTest::keyClicks(&window.field, "77");
        QTest::keyClick(&window.field, Qt::Key_Escape);
        window.other.setFocus();
        QCOMPARE(window.field.value(), 2.0);
        QCOMPARE(window.edits.count(), 0);
    }
    void arrowStepsChangeTheSecondDigitAndMerge() {
        Window window;
        window.field.setValue(1.0);
        window.field.setFocus();
        QTest::keyClick(&window.field, Qt::Key_Up);
        QCOMPARE(window.field.value(), 1.1);
        QTest::keyClick(&window.field, Qt::Key_Down);
        QTest::keyClick(&window.field, Qt::Key_Down);
        QCOMPARE(window.field.value(), 0.99);
        QCOMPARE(window.edits.count(), 3);
        QCOMPARE(window.starts.count(), 1);
        window.other.setFocus();
        window.field.setFocus();
        QTest::keyClick(&window.field, Qt::Key_Up);
        QCOMPARE(window.starts.count(), 2);
    }
    void stepsStayInRange() {
        Window window;
        window.field.setRange(FieldRange::whole(1, 3));
        window.field.setValue(2.0);
        window.field.setFocus();
        for (int k = 0; k < 3; ++k) QTest::keyClick(&window.field, Qt::Key_Up);
        QCOMPARE(window.field.value(), 3.0);
        for (int k = 0; k < 5; ++k) QTest::keyClick(&window.field, Qt::Key_Down);
        QCOMPARE(window.field.value(), 1.0);
    }
    void wheelChangesTheValueOnlyWithFocus() {
        Window window;
        window.field.setValue(1.0);
        wheel(window.field, 1);
        QCOMPARE(window.field.value(), 1.0);
        window.field.setFocus();
        wheel(window.field, 1);
        QCOMPARE(window.field.value(), 1.1);
    }
    void mixedFieldIsEmptyUntilTyped() {
        Window window;
        window.field.setMixed();
        QCOMPARE(window.line().text(), "");
        window.field.setFocus();
        QTest::keyClick(&window.field, Qt::Key_Up);
        window.other.setFocus();
        QCOMPARE(window.edits.count(), 0);
        window.type("0");
        QCOMPARE(window.edits.count(), 1);  // though the value was 0 before
        QVERIFY(!window.field.isMixed());
    }
    void sliderDragMergesIntoOneEdit() {
        SliderField slider(FieldRange::zeroOrAbove(), 0.0, 10.0);
        slider.resize(400, 30);
        slider.show();
        slider.setValue(0.0);
        QSignalSpy starts(&slider, &SliderField::editingStarted);
        QSignalSpy edits(&slider, &SliderField::edited);
        const int middle = slider.slider().height() / 2;
        QTest::mousePress(&slider.slider(), Qt::LeftButton, {}, {6, middle});
        for (const int x : {40, 80, 120}) QTest::mouseMove(&slider.slider(), {x, middle});
        QTest::mouseRelease(&slider.slider(), Qt::LeftButton, {}, {120, middle});
        QCOMPARE(starts.count(), 1);
        QVERIFY(edits.count() >= 3);
        QVERIFY(slider.value() > 1.0 && slider.value() < 10.0);
        QCOMPARE(slider.field().value(), slider.value());
    }
    void settingAnotherValueEndsTheDrag() {
        SliderField slider(FieldRange::zeroOrAbove(), 0.0, 10.0);
        slider.resize(400, 30);
        slider.show();
        const int middle = slider.slider().height() / 2;
        QTest::mousePress(&slider.slider(), Qt::LeftButton, {}, {6, middle});
        QTest::mouseMove(&slider.slider(), {80, middle});
        QVERIFY(slider.value() > 1.0);
        slider.setValue(0.0);  // as if the drag was undone before it ends
        QSignalSpy edits(&slider, &SliderField::edited);
        QTest::mouseMove(&slider.slider(), {120, middle});
        QTest::mouseRelease(&slider.slider(), Qt::LeftButton, {}, {120, middle});
        QCOMPARE(edits.count(), 0);
        QCOMPARE(slider.value(), 0.0);
        QCOMPARE(slider.slider().value(), 0);
    }
    void sliderNeverChangesTheValueItShows() {
        SliderField slider(FieldRange::aboveZero(), 0.01, 100.0, SliderScale::Logarithmic);
        QSignalSpy edits(&slider, &SliderField::edited);
        for (const double value : {1.0 / 3.0, 12345.678, 1e-9}) {
            slider.setValue(value);
            QCOMPARE(slider.value(), value);
        }
        QCOMPARE(edits.count(), 0);
        slider.setValue(1.0);
        QCOMPARE(slider.slider().value(), slider.slider().maximum() / 2);
    }
};

RUBBLE_TEST_WITH(NumberFieldTest, QApplication)
#include "NumberFieldTest.moc"
