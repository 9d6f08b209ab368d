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
    void controlsAreEscaped() {
        QCOMPARE(printableText("wall \u00e4\U0001F9F1\n\t."), std::string("wall \u00e4\U0001F9F1\n\t."));
        QCOMPARE(printableText("\x1b[31m\x7f\u009b\u202e\u200f\u2028"),
                 std::string("\\u001b[31m\\u007f\\u009b\\u202e\\u200f\\u2028"));
        QCOMPARE(printableText("h\xff\xe2\x80"), std::string("h\\xff\\xe2\\x80"));
        QCOMPARE(printableText(printableText("\x1b")), std::string("\\u001b"));
    }
    void namesFitASentence() {
        QCOMPARE(quotedName("wall"), std::string("\"wall\""));
        QCOMPARE(quotedName(""), std::string("\"\""));
        QCOMPARE(shownName(std::string(60, 'x')), std::string(60, 'x'));
        QCOMPARE(shownName("a" + std::string(100000, 'x') + "z"),
                 "a" + std::string(29, 'x') + "\u2026" + std::string(28, 'x') + "z");
        QCOMPARE(shownName("two\nlines\t\x1b"), std::string("two\\u000alines\\u0009\\u001b"));
        QCOMPARE(shownName("h\xff"), std::string("h\\xff"));
    }
    void longNamesAreCutBetweenCharacters() {
        std::string umlauts, escapes, wrong(1000, '\x80');
        for (int k = 0; k < 100; ++k) umlauts += "\u00e4";
        for (int k = 0; k < 100; ++k) escapes += '\x1b';
        const auto halves = [](const std::string& character, int first, int second) {
            std::string text;
            for (int k = 0; k < first; ++k) text += character;
            text += "\u2026";
            for (int k = 0; k < second; ++k) text += character;
            return text;
        };
        QCOMPARE(shownName(umlauts), halves("\u00e4", 30, 29));
        QCOMPARE(shownName(escapes), halves("\\u001b", 5, 4));
        QCOMPARE(shownName(wrong), halves("\\x80", 7, 7));
    }
    void manyNamesAreCounted() {
        QCOMPARE(quotedNames({}), std::string());
        QCOMPARE(quotedNames({"a", "b"}), std::string("\"a\", \"b\""));
        QCOMPARE(QString::fromStdString(quotedNames(std::vector<std::string>(20, "a"))).count("\"a\""), 20);
        const QString many = QString::fromStdString(quotedNames(std::vector<std::string>(1000, "a")));
        QVERIFY2(many.endsWith(", \"a\" and 981 more") && many.count("\"a\"") == 19, qPrintable(many));
    }
    void pathsAreWhole() {
        const std::string path = "/" + std::string(300, 'x') + "/h\xff\n";
        QCOMPARE(quotedPath(path), "\"/" + std::string(300, 'x') + "/h\\xff\\u000a\"");
    }
};

RUBBLE_TEST(MessageTextTest)
#include "MessageTextTest.moc"
