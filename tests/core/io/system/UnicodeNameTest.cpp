#include "core/io/system/UnicodeName.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class UnicodeNameTest : public QObject {
    Q_OBJECT
private slots:
    void charactersHaveAKind() {
        for (const char32_t code : {U'a', U'ä', U'漢', U'-', U'\U0001F600'})
            QVERIFY(nameCharacterOf(code) == NameCharacter::Visible);
        for (const char32_t code : {U' ', U'\u00A0', U'\u3000'}) QVERIFY(nameCharacterOf(code) == NameCharacter::Space);
        // A control, a direction mark, a line separator, a soft hyphen, a filler, a private one and no text.
        for (const char32_t code : {U'\n', U'\u202E', U'\u2028', U'\u00AD', U'\u3164', U'\uE000', U'\uFFFD'})
            QVERIFY(nameCharacterOf(code) == NameCharacter::Invisible);
    }
    void codePointsAreComposed() {
        QVERIFY(composedCodePoints("a\u0308") == U"ä");
        QVERIFY(composedCodePoints("a\xff") == U"a\uFFFD");
        QCOMPARE(utf8Of(U"aä漢\U0001F600"), "aä漢\U0001F600");
    }
    void lengthIsTheLargerOfBytesAndDecomposedUnits() {
        QCOMPARE(nameLength("abc"), std::size_t{3});
        QCOMPARE(nameLength("漢"), std::size_t{3});          // bytes
        QCOMPARE(nameLength("\U0001D160"), std::size_t{6});  // a musical note: three characters of two units
    }
    void equalNamesHaveOneKey() {
        QCOMPARE(nameKey("WALL"), nameKey("wall"));
        QCOMPARE(nameKey("a\u0308"), nameKey("Ä"));
        QCOMPARE(nameKey("x²"), nameKey("x2"));
        QCOMPARE(nameKey("a\u00ADb"), nameKey("ab"));
        QCOMPARE(nameKey("ı"), nameKey("i"));  // as Windows compares
        QCOMPARE(nameKey("straße"), nameKey("STRASSE"));
    }
    void otherNamesHaveOtherKeys() {
        QVERIFY(nameKey("wall") != nameKey("wal"));
        QVERIFY(nameKey("ä") != nameKey("a"));
        QVERIFY(nameKey("a b") != nameKey("ab"));
    }
};

RUBBLE_TEST(UnicodeNameTest)
#include "UnicodeNameTest.moc"
