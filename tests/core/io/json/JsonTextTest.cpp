#include "core/io/json/JsonText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {
std::string jsonOf(std::string_view text) {
    std::string json;
    appendJsonText(json, text);
    return json;
}
}  // namespace

class JsonTextTest : public QObject {
    Q_OBJECT
private slots:
    void plainTextAndUtf8AreUnchanged() { QCOMPARE(jsonOf("wall Größe 3"), std::string("\"wall Größe 3\"")); }
    void quotesBackslashesAndLineEndsAreEscaped() {
        QCOMPARE(jsonOf("a\"b\\c\nd\te"), std::string("\"a\\\"b\\\\c\\nd\\te\""));
    }
    void controlCharactersAreEscapedByCode() {
        QCOMPARE(jsonOf(std::string_view("\x01\x1f\0", 3)), std::string("\"\\u0001\\u001f\\u0000\""));
    }
    void bytesThatAreNoTextAreReplaced() { QCOMPARE(jsonOf("h\xff\"\xc3"), std::string("\"h\ufffd\\\"\ufffd\"")); }
    void emptyTextIsTwoQuotes() { QCOMPARE(jsonOf(""), std::string("\"\"")); }
};

RUBBLE_TEST(JsonTextTest)
#include "JsonTextTest.moc"
