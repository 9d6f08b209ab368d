#include "core/base/QuantityText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <limits>

using namespace rubble;

class QuantityTextTest : public QObject {
    Q_OBJECT

private slots:
    void unitSuitsTheSize_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        const auto add = [](QuantityKind kind, double value, const char* text) {
            QTest::newRow(text) << static_cast<int>(kind) << value << QString::fromUtf8(text);
        };
        add(QuantityKind::Length, 2.5, "2.5 m");
        add(QuantityKind::Length, 0.1, "0.1 m");
        add(QuantityKind::Length, 0.075, "75 mm");
        add(QuantityKind::Length, 2.5e-5, "25 µm");
        add(QuantityKind::Length, 0.0, "0 m");
        add(QuantityKind::Area, 0.0191, "191 cm²");
        add(QuantityKind::Area, 12.0, "12 m²");
        add(QuantityKind::Volume, 0.075, "0.075 m³");
        add(QuantityKind::Volume, 2.5e-4, "250 cm³");
        add(QuantityKind::Mass, 0.0, "0 kg");
        add(QuantityKind::Mass, 0.025, "25 g");
        add(QuantityKind::Mass, 25000.0, "25 t");
        add(QuantityKind::Density, 2400.0, "2400 kg/m³");
        add(QuantityKind::Time, 0.0166, "16.6 ms");
        add(QuantityKind::Speed, 0.001, "1 mm/s");
        add(QuantityKind::Force, 4905.0, "4.905 kN");
        add(QuantityKind::Impulse, 1229.39, "1229 N·s");
        add(QuantityKind::Impulse, 100000.0, "100 kN·s");
        add(QuantityKind::Energy, 2500.0, "2.5 kJ");
        add(QuantityKind::Pressure, 3.5e7, "35 MPa");
    }
    void unitSuitsTheSize() {
        QFETCH(int, kind);
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(quantityText(static_cast<QuantityKind>(kind), value)), text);
    }

    void numbersHaveFourSignificantDigits() {
        QCOMPARE(roundedNumber(0.707106781), std::string("0.7071"));
        QCOMPARE(roundedNumber(5.729578), std::string("5.73"));
        QCOMPARE(roundedNumber(99.996), std::string("100"));
        QCOMPARE(roundedNumber(-12.3456), std::string("-12.35"));
        QCOMPARE(roundedNumber(123456.7), std::string("123457"));
        QCOMPARE(roundedNumber(0.000117041666), std::string("0.000117"));
        QCOMPARE(roundedNumber(0.0), std::string("0"));
    }

    void exponentsAreForExtremeNumbersOnly() {
        QCOMPARE(roundedNumber(2.5e20), std::string("2.5e+20"));
        QCOMPARE(roundedNumber(2.5e-9), std::string("2.5e-09"));
        QCOMPARE(roundedNumber(std::numeric_limits<double>::infinity()), std::string("inf"));
    }

    void countsHaveSingularAndPlural() {
        QCOMPARE(countText(0, "fragment", "fragments"), std::string("0 fragments"));
        QCOMPARE(countText(1, "fragment", "fragments"), std::string("1 fragment"));
        QCOMPARE(countText(2, "fragment", "fragments"), std::string("2 fragments"));
    }
};

RUBBLE_TEST(QuantityTextTest)
#include "QuantityTextTest.moc"
