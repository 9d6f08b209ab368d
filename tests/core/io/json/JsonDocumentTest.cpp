// Tests core/io/json/JsonDocument.cpp and core/io/json/JsonParsing.cpp.
#include "core/io/json/JsonDocument.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"

#include <QTest>
#include <functional>

using namespace rubble;

namespace {

constexpr const char* kEveryKind =
    "{\"no\": null, \"yes\": true, \"count\": 3, \"big\": 18446744073709551615, \"low\": -2, \"half\": 5e-1,\n"
    "\"name\": \"a\\u00e9\\\"\", \"list\": [[1, 2], [3, 4], []]}";

/// Returns the error of parsing the text, or "".
std::string parseFault(std::string_view text) { return errorText(JsonDocument::parse(text)); }

/// Returns the error of reading the text, or "".
std::string readFault(std::string_view text, const std::function<void(JsonValue)>& read) {
    Result<JsonDocument> document = JsonDocument::parse(text);
    if (!document) return document.error().message;
    read(document->root());
    return document->firstError() ? document->firstError()->message : "";
}

}  // namespace

class JsonDocumentTest : public QObject {
    Q_OBJECT
private slots:
    void emptyTextIsCalledEmpty() {
        for (const char* text : {"", " \n\t"})
            QCOMPARE(JsonDocument::parse(text).error().message, std::string("The text is empty; it should be JSON."));
    }
    /// A short text must not become many large values.
    void listEndsAtItsFirstError() {
        std::string text = "[1";
        for (int k = 0; k < 100'000; ++k) text += ",1";
        int reads = 0;
        const std::string fault = readFault(text + "]", [&](JsonValue root) {
            const auto list = root.list([&](JsonValue element) {
                ++reads;
                element.requireObject({"id"});
                return std::array<double, 64>();
            });
            QCOMPARE(list.size(), std::size_t{1});
            QVERIFY(list.capacity() < 10'000);
        });
        QCOMPARE(reads, 1);
        QCOMPARE(fault, std::string("[0]: expected an object, found 1."));
    }
    void tooManyValuesAreRejectedBeforeTheyAreRead() {
        QCOMPARE(parseFault("[" + std::string(kMaxJsonValues, ',')),
                 std::string("The JSON has more than 33554432 values."));
        QVERIFY(checkJsonSize("[" + std::string(kMaxJsonValues - 2, ',')));
    }
    void nothingFollowsTheValue() {
        using namespace std::string_view_literals;
        QCOMPARE(parseFault("{}\0 and more"sv),
                 std::string("The text is not JSON at line 1, column 3: it contains a byte of value 0."));
        QCOMPARE(parseFault("{\n\"a\": \"\0\"}"sv),
                 std::string("The text is not JSON at line 2, column 7: it contains a byte of value 0."));
        QVERIFY(!parseFault("{}\n\0"sv).empty());
        QVERIFY(!parseFault("{} {}").empty());
        QVERIFY(!parseFault("{}x").empty());
        QCOMPARE(parseFault("{}\n \t\r\n"), std::string());
    }
    void valuesOfEveryKindAreRead() {
        Result<JsonDocument> document = JsonDocument::parse(kEveryKind);
        QVERIFY(document);
        const JsonValue root = document->root();
        QVERIFY(root["no"].isNull());
        QVERIFY(!root["none"].isPresent());
        QCOMPARE(root["yes"].boolean(), true);
        QCOMPARE(root["count"].index(), 3u);
        QCOMPARE(root["big"].wholeNumber(), ~std::uint64_t{0});
        QCOMPARE(root["low"].number(), -2.0);
        QCOMPARE(root["half"].number(), 0.5);
        QCOMPARE(root["name"].text(), std::string("a\xc3\xa9\""));
        std::vector<double> sums;
        for (const JsonValue list : root["list"].elements()) {
            double sum = 0.0;
            for (const JsonValue element : list.elements()) sum += element.number();
            sums.push_back(sum);
        }
        QCOMPARE(sums, (std::vector<double>{3.0, 7.0, 0.0}));
        QCOMPARE(root["list"].elements().size(), 3u);
        QVERIFY(!document->firstError());
    }
    void listsAndPointsAreRead() {
        QCOMPARE(readFault("[[[1, 2], [3, -4.5]], []]",
                           [](JsonValue value) {
                               const std::vector<std::vector<Vec2>> rings = value.list(&JsonValue::points);
                               QVERIFY((rings == std::vector<std::vector<Vec2>>{{{1.0, 2.0}, {3.0, -4.5}}, {}}));
                           }),
                 std::string());
        QCOMPARE(readFault("[[1, 2, 3]]", [](JsonValue value) { value.points(); }),
                 std::string("[0]: expected an array of 2 numbers, found an array of 3."));
        QCOMPARE(readFault("{\"a\": \"b\"}", [](JsonValue value) { QVERIFY(value["a"].points().empty()); }),
                 std::string("a: expected an array, found \"b\"."));
    }
    void wholeNumbersMayBeWrittenAsReals() {
        QCOMPARE(readFault("[3.0, 3e2]",
                           [](JsonValue value) {
                               std::uint32_t sum = 0;
                               for (const JsonValue element : value.elements()) sum += element.index();
                               QCOMPARE(sum, 303u);
                           }),
                 std::string());
    }
    void errorsNameThePath() {
        const std::string text = R"({"assets": [{}, {}, {"prism": {"depth": "two"}}]})";
        const auto readDepth = [](JsonValue root) {
            for (const JsonValue asset : root["assets"].elements())
                if (asset["prism"].isPresent()) asset["prism"]["depth"].number(above(0.0));
        };
        QCOMPARE(readFault(text, readDepth),
                 std::string("assets[2].prism.depth: expected a number above 0, found \"two\"."));
    }
    void wrongTypesAndRangesAreReported_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const char* text, const char* kind, const char* fault) {
            QTest::newRow(name) << QString(text) << QString(kind) << QString(fault);
        };
        row("number from null", "[null]", "any", "[0]: expected a number, found null.");
        row("zero", "[0]", "above", "[0]: expected a number above 0, found 0.");
        row("negative", "[-0.5]", "atLeast", "[0]: expected a number of at least 0, found -0.5.");
        row("too large", "[1.5]", "between", "[0]: expected a number from 0 to 1, found 1.5.");
        row("fraction", "[1.5]", "index", "[0]: expected a whole number from 0 to 4294967295, found 1.5.");
        row("negative index", "[-1]", "index", "[0]: expected a whole number from 0 to 4294967295, found -1.");
        row("index too large", "[4294967296]", "index",
            "[0]: expected a whole number from 0 to 4294967295, found 4294967296.");
        row("index far too large", "[1e300]", "index",
            "[0]: expected a whole number from 0 to 4294967295, found 1e+300.");
        row("text from array", "[[1, 2]]", "text", "[0]: expected a text, found an array of 2.");
        row("boolean from object", "[{}]", "boolean", "[0]: expected true or false, found an object.");
        row("word", R"(["oval"])", "word", R"([0]: expected "box" or "ball", found "oval".)");
        row("word from true", "[true]", "word", R"([0]: expected "box" or "ball", found true.)");
        row("elements", "[7]", "elements", "[0]: expected an array, found 7.");
        row("pair", "[[1, 2, 3]]", "pair", "[0]: expected an array of 2 numbers, found an array of 3.");
        row("pair of texts", R"([[1, "2"]])", "pair", R"([0][1]: expected a number, found "2".)");
        row("object", "[false]", "object", "[0]: expected an object, found false.");
        row("missing key", "[{}]", "object", R"([0]: the key "a" is missing.)");
        row("unknown key", R"([{"a": 1, "c": 2}])", "object", R"([0]: unknown key "c".)");
        row("odd key", R"([{"a": 1, "new\nline": 2}])", "object", R"([0]: unknown key "new\u000aline".)");
        row("key with DEL", "[{\"a\": 1, \"new\x7fline\": 2}]", "object", R"([0]: unknown key "new\u007fline".)");
    }
    void wrongTypesAndRangesAreReported() {
        QFETCH(QString, text);
        QFETCH(QString, kind);
        const auto read = [&](JsonValue root) {
            static constexpr std::string_view kWords[] = {"box", "ball"};
            for (const JsonValue value : root.elements()) {
                if (kind == "any") value.number();
                if (kind == "above") value.number(above(0.0));
                if (kind == "atLeast") value.number(atLeast(0.0));
                if (kind == "between") value.number(between(0.0, 1.0));
                if (kind == "index") value.index();
                if (kind == "text") value.text();
                if (kind == "boolean") value.boolean();
                if (kind == "word") value.oneOf(kWords);
                if (kind == "elements") value.elements();
                if (kind == "pair") value.numbers<2>();
                if (kind == "object") value.requireObject({"a"}, {"b"});
            }
        };
        QTEST(QString::fromStdString(readFault(text.toStdString(), read)), "fault");
    }
    void firstErrorIsKeptAndLaterReadsReturnDefaults() {
        QCOMPARE(readFault(R"({"a": 1, "b": [2], "c": "three"})",
                           [](JsonValue root) {
                               root["a"].text();
                               QCOMPARE(root["b"].elements().size(), 0u);
                               QCOMPARE(root["c"].text(), std::string());
                               root["c"].fail("is late");
                           }),
                 std::string("a: expected a text, found 1."));
    }
    void errorAtTheRootIsASentence() {
        QCOMPARE(readFault("3", [](JsonValue root) { root.requireObject({}); }),
                 std::string("The document: expected an object, found 3."));
    }
    void syntaxErrorsHaveLineAndColumn_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("start");
        const auto row = [](const QByteArray& text, const char* start) { QTest::newRow(start) << text << start; };
        row("{\"a\": 1,\n \"b\": ]", "The text is not JSON at line 2, column 7: unexpected ']'");
        row("[1, nul]", "The text is not JSON at line 1, column 8: invalid literal");
        row("[1] 2", "The text is not JSON at line 1, column 5: unexpected number literal; expected end of input");
        row("[1e999]", "The text is not JSON at line 1, column 6: a number is too large");
        row("[NaN]", "The text is not JSON at line 1, column 2: invalid literal");
        row("[\"\xff\"]", "The text is not JSON at line 1, column 3: invalid string: ill-formed UTF-8 byte");
        row("[\"a", "The text is not JSON at line 1, column 4: invalid string: missing closing quote");
    }
    void syntaxErrorsHaveLineAndColumn() {
        QFETCH(QByteArray, text);
        QFETCH(QString, start);
        const QString fault = QString::fromStdString(parseFault(text.toStdString()));
        QVERIFY2(fault.startsWith(start) && fault.endsWith('.'), qPrintable(fault));
    }
    void duplicateKeysAreRejected() {
        QCOMPARE(parseFault(R"({"a": [{"b": 1, "c": 2, "b": 3}]})"), std::string(R"(a[0]: the key "b" is repeated.)"));
        QCOMPARE(parseFault(R"({"b": 1, "b": 3})"), std::string(R"(The document: the key "b" is repeated.)"));
    }
    void depthIsLimited() {
        const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
        QCOMPARE(parseFault(nested(64)), std::string());
        QCOMPARE(JsonDocument::parse(nested(65)).error().code, ErrorCode::Limit);
        QCOMPARE(parseFault(std::string(1000000, '[')), std::string("The JSON is nested deeper than 64 levels."));
    }
    void sizeIsLimited() {
        const std::string text((std::size_t{256} << 20) + 1, ' ');
        QCOMPARE(JsonDocument::parse(text).error().code, ErrorCode::Limit);
    }
};

RUBBLE_TEST(JsonDocumentTest)
#include "JsonDocumentTest.moc"
