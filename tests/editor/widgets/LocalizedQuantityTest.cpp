#include "editor/widgets/LocalizedQuantity.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

QString plainText(QuantityKind kind, double value, LengthUnit unit = LengthUnit::Metre,
                  const QLocale& locale = QLocale::c()) {
    return localizedQuantity(kind, value, {unit}, locale).replace(QChar(QChar::Nbsp), ' ');
}

}  // namespace

class LocalizedQuantityTest : public QObject {
    Q_OBJECT
private slots:
    void numbersAreRoundedToFourDigits() {
        QCOMPARE(plainText(QuantityKind::Volume, 0.0750000001), "0.075 m³");
        QCOMPARE(plainText(QuantityKind::Area, 0.00011704166666667374), "1.17 cm²");
        QCOMPARE(plainText(QuantityKind::Impulse, 1229.39), "1229 N·s");
    }
    void lengthsAreInThePreferredUnit() {
        QCOMPARE(plainText(QuantityKind::Length, 1.2345678, LengthUnit::Millimetre), "1235 mm");
        QCOMPARE(plainText(QuantityKind::Area, 0.0191, LengthUnit::Centimetre), "191 cm²");
        QCOMPARE(plainText(QuantityKind::Mass, 2.5, LengthUnit::Millimetre), "2.5 kg");
    }
    void extremeValuesHaveAnotherUnit() {
        QCOMPARE(plainText(QuantityKind::Volume, 0.5, LengthUnit::Millimetre), "0.5 m³");
        QCOMPARE(plainText(QuantityKind::Length, 4e-5, LengthUnit::Centimetre), "40 µm");
    }
    void digitsAreThoseOfTheLocale() {
        const QLocale german(QLocale::German, QLocale::Germany);
        QCOMPARE(plainText(QuantityKind::Length, 1.25, LengthUnit::Metre, german), "1,25 m");
    }
};

RUBBLE_TEST(LocalizedQuantityTest)
#include "LocalizedQuantityTest.moc"
