#include "core/base/MessageText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <limits>

using namespace rubble;

class MessageTextTest : public QObject {
    Q_OBJECT
private slots:
    void textIsShortestRoundTrip() {
        QCOMPARE(messageText(0.1), std::string("0.1"));
        QCOMPARE(messageText(-3.0), std::string("-3"));
        QCOMPARE(messageText(1e-9), std::string("1e-09"));
        QCOMPARE(messageText(0.1 + 0.2), std::string("0.30000000000000004"));
    }
    void commonMagnitudesHaveNoExponent() {
        QCOMPARE(messageText(0.0005), std::string("0.0005"));
        QCOMPARE(messageText(-1e-6), std::string("-0.000001"));
        QCOMPARE(messageText(100000.0), std::string("100000"));
        QCOMPARE(messageText(1e15), std::string("1e+15"));
        QCOMPARE(messageText(-1.2345678901234567e-6), std::string("-0.0000012345678901234567"));
        QCOMPARE(messageText(0.0), std::string("0"));
    }
    void roundedTextHasSignificantDigits() {
        QCOMPARE(roundedText(2.0 / 3.0, 3), std::string("0.667"));
        QCOMPARE(roundedText(12.0, 1), std::string("1e+01"));
        QCOMPARE(roundedText(-2.2250738585072014e-308, 17), std::string("-2.2250738585072014e-308"));
    }
    void longestAndNonFiniteNumbersFit() {
        QCOMPARE(messageText(-2.2250738585072014e-308), std::string("-2.2250738585072014e-308"));
        QCOMPARE(messageText(std::numeric_limits<double>::quiet_NaN()), std::string("nan"));
        QCOMPARE(messageText(-std::numeric_limits<double>::infinity()), std::string("-inf"));
    }
};

RUBBLE_TEST(MessageTextTest)
#include "MessageTextTest.moc"
