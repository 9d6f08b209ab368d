#include "editor/widgets/numbers/LocalizedQuantity.h"

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
    void thePreferredUnitIsKeptForAllSizes() {
        QCOMPARE(plainText(QuantityKind::Area, 6.0, LengthUnit::Centimetre), "60000 cm²");
        QCOMPARE(plainText(QuantityKind::Volume, 1.8, LengthUnit::Centimetre), "1800000 cm³");
        QCOMPARE(plainText(QuantityKind::Length, 4e-5, LengthUnit::Centimetre), "0.004 cm");
        QCOMPARE(plainText(QuantityKind::Length, 1.6002, LengthUnit::Foot), "5.25 ft");
        QCOMPARE(plainText(QuantityKind::Volume, 0.3048 * 0.3048 * 0.3048, LengthUnit::Foot), "1 ft³");
    }
    void oneDisplayHasOneUnit() {
        const NumberFormat format = quantityFormat(QuantityKind::Volume, 1.2);
        QCOMPARE(roundedQuantity(1.2e-5, format, QLocale::c()), QString("0.000012\u00a0m³"));
        QCOMPARE(quantityFormat(QuantityKind::Mass, 0.05).unit, "g");
        QCOMPARE(roundedQuantity(0.002, quantityFormat(QuantityKind::Mass, 0.05), QLocale::c()), QString("2\u00a0g"));
    }
    void runningNumbersKeepTheirDecimals() {
        QCOMPARE(fixedQuantity(0.5, 2, Units::seconds(), QLocale::c()), QString("0.50\u00a0s"));
        QCOMPARE(fixedQuantity(0.01234, 5, Units::milliseconds(), QLocale::c()), QString("12.34\u00a0ms"));
    }
    /// A tolerance that is rounded down would be too small.
    void smallLengthsAreRoundedUp() {
        QCOMPARE(smallLengthText(0.0000021, {}, QLocale::c()), QString("0.003\u00a0mm"));
        QCOMPARE(smallLengthText(0.001, {}, QLocale::c()), QString("1\u00a0mm"));
        QCOMPARE(smallLengthText(0.0254, {LengthUnit::Foot}, QLocale::c()), QString("1\u00a0in"));
        QCOMPARE(smallLengthText(0.0254 * 0.00011, {LengthUnit::Foot}, QLocale::c()), QString("0.0002\u00a0in"));
    }
    void digitsAreThoseOfTheLocale() {
        const QLocale german(QLocale::German, QLocale::Germany);
        QCOMPARE(plainText(QuantityKind::Length, 1.25, LengthUnit::Metre, german), "1,25 m");
    }
};

RUBBLE_TEST(LocalizedQuantityTest)
#include "LocalizedQuantityTest.moc"
