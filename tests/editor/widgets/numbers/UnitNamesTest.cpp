#include "editor/widgets/numbers/UnitNames.h"

#include "editor/widgets/numbers/NumberText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class UnitNamesTest : public QObject {
    Q_OBJECT
private slots:
    void typedUnitsAreConverted_data() {
        QTest::addColumn<NumberFormat>("format");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        const auto row = [](const NumberFormat& format, const char* text, double value) {
            QTest::newRow(qPrintable(format.unit + ": " + text)) << format << QString(text) << value;
        };
        const Units metres, feet{LengthUnit::Foot};
        for (const Units& units : {metres, feet, Units{LengthUnit::Centimetre}}) {
            row(units.lengths(), "12 mm", 0.012);
            row(units.lengths(), "40 CM", 0.4);
            row(units.lengths(), "3'", 0.9144);
            row(units.lengths(), "5' 3\"", 1.6002);
            row(units.lengths(), "-5'3''", -1.6002);
            row(units.lengths(), "5 ft 3.5 in", 1.6129);
            row(units.lengths(), "1 m 20 cm", 1.2);
            row(units.lengths(), "2 in", 0.0508);
            row(units.areas(), "3 cm2", 3e-4);
            row(units.areas(), "2 sq ft", 2 * 0.3048 * 0.3048);
            row(units.volumes(), "1.5 l", 1.5e-3);
            row(units.volumes(), "8 cm^3", 8e-6);
            row(units.volumes(), "2 ft³", 2 * 0.3048 * 0.3048 * 0.3048);
        }
        row(feet.lengths(), "5.25", 1.6002);
        row(Units::masses(), "50 g", 0.05);
        row(Units::masses(), "2 lb 4 oz", 1.0205828325);
        row(Units::masses(), "1.5 t", 1500.0);
        row(Units::densities(), "2.4 g/cm³", 2400.0);
        row(Units::densities(), "150 lb/ft3", 150 * 0.45359237 / (0.3048 * 0.3048 * 0.3048));
        row(Units::milliseconds(), "2 s", 2.0);
        row(Units::milliseconds(), "4", 0.004);
        row(Units::seconds(), "1 min 30 s", 90.0);
        row(Units::speeds(), "36 km/h", 10.0);
        row(Units::speeds(), "10 mph", 4.4704);
        row(Units::accelerations(), "-1 g", -9.80665);
        row(Units::forces(), "2 kN", 2000.0);
        row(Units::energies(), "2 kJ", 2000.0);
        row(Units::energies(), "0.5 Nm", 0.5);
        row(Units::energies(), "3 ft lbf", 3 * 0.3048 * 4.4482216152605);
        row(Units::impulses(), "1.2 kNs", 1200.0);
        row(Units::impulses(), "3 N s", 3.0);
        row(Units::impulsesPerArea(), "2 kPa*s", 2000.0);
        row(Units::megapascals(), "400 kPa", 4e5);
        row(Units::gigapascals(), "30 N/mm2", 3e7);
        row(Units::toughnesses(), "700 kPa sqrt(m)", 7e5);
        row(Units::angles(), "30 deg", 30.0);
        row(Units::perMetre(), "2 per cm", 200.0);
        row(Units::perMetre(), "2/cm", 200.0);
        row(Units::percents(), "25 %", 0.25);
        row(Units::percents(), "25", 0.25);
        row(Units::percents(), "5‰", 0.005);
    }
    void typedUnitsAreConverted() {
        QFETCH(NumberFormat, format);
        QFETCH(QString, text);
        QFETCH(double, value);
        const std::optional<double> typed = parseNumber(text, format, QLocale::c());
        QVERIFY(typed);
        QVERIFY2(std::abs(*typed - value) <= 1e-14 * std::abs(value), qPrintable(QString::number(*typed, 'g', 17)));
    }
    void otherUnitsAreRejected_data() {
        QTest::addColumn<NumberFormat>("format");
        QTest::addColumn<QString>("text");
        const auto row = [](const NumberFormat& format, const char* text) {
            QTest::newRow(qPrintable(format.unit + ": " + text)) << format << QString(text);
        };
        row(Units().lengths(), "5 kg");
        row(Units().lengths(), "3' 2");    // of what?
        row(Units().lengths(), "3\" 5'");  // the larger unit comes first
        row(Units().lengths(), "5 m 3 kg");
        row(Units().areas(), "5 m");
        row(Units::masses(), "3'");
        row(Units::masses(), "50 grammes of sugar");
        row(Units::forces(), "5 mN");  // is no meganewton
        row(Units::megapascals(), "5 mPa");
        row(Units::speeds(), "5 m");
        row({}, "5 m");
        row({QStringLiteral("%")}, "5 m");
    }
    void otherUnitsAreRejected() {
        QFETCH(NumberFormat, format);
        QFETCH(QString, text);
        QVERIFY(!parseNumber(text, format, QLocale::c()));
    }
    void allNamesOfAFamilyAreKnown() {
        for (int family = 1; family <= static_cast<int>(UnitFamily::Fraction); ++family) {
            const QStringList names = unitNames(static_cast<UnitFamily>(family));
            QVERIFY(!names.isEmpty());
            for (const QString& name : names)
                QVERIFY2(unitNamed(static_cast<UnitFamily>(family), name), qPrintable(name));
        }
    }
    void feetReadBackBitForBit() {
        const Units feet{LengthUnit::Foot};
        QCOMPARE(exactText(0.3048, feet.lengths(), QLocale::c()), "1");
        QCOMPARE(exactText(1.6002, feet.lengths(), QLocale::c()), "5.25");
        QCOMPARE(exactText(-0.1524, feet.lengths(), QLocale::c()), "-0.5");
        QCOMPARE(exactText(0.0, feet.lengths(), QLocale::c()), "0");
        double value = 1e-9;
        for (int k = 0; k < 2000; ++k) {
            value *= 1.0 + 1.0 / (3.0 + k % 41);
            if (value > 1e12) value = 1e-9 * (1.0 + k / 3000.0);
            for (const NumberFormat& format : {feet.lengths(), feet.areas(), feet.volumes()}) {
                QCOMPARE(parseNumber(exactText(value, format, QLocale::c()), format, QLocale::c()), value);
            }
        }
    }
};

RUBBLE_TEST(UnitNamesTest)
#include "UnitNamesTest.moc"
