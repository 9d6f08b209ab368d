#include "editor/widgets/numbers/Decimal.h"

#include "tests/support/TestProgram.h"

#include <limits>

using namespace rubble;

class DecimalTest : public QObject {
    Q_OBJECT
private slots:
    void shortestDecimalHasOnlyTheDigitsThatAreNeeded() {
        QCOMPARE(shortestDecimal(0.1).digits, "1");
        QCOMPARE(shortestDecimal(-12.5).digits, "125");
        QVERIFY(shortestDecimal(-12.5).isNegative);
        QCOMPARE(shortestDecimal(-12.5).exponent, 2);
        QVERIFY(shortestDecimal(0.0).digits.isEmpty());
    }
    void textsAreReadBack() {
        for (const double value : {0.0, 0.1, -1.25e-7, 3048.0, 1e300, 5e-324}) {
            QCOMPARE(valueOf(decimalOf(textOf(shortestDecimal(value)))), std::optional(value));
        }
    }
    /// 0.07 m is 7 cm, and 0.3048 m a foot.
    void productsAndQuotientsAreExact() {
        QCOMPARE(textOf(product(decimalOf("0.07"), 100)), "7");
        QCOMPARE(textOf(product(decimalOf("99999999999999999999"), 3)), "2.99999999999999999997e20");
        QCOMPARE(textOf(quotient(decimalOf("0.3048"), 3048, 17)), "0.0001");
        QCOMPARE(textOf(quotient(decimalOf("2"), 3, 4)), "0.6667");
    }
    void numbersBeyondDoubleAreNone() { QVERIFY(!valueOf(decimalOf("1e400"))); }
};

RUBBLE_TEST(DecimalTest)
#include "DecimalTest.moc"
