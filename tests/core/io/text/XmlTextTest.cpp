#include "core/io/text/XmlText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class XmlTextTest : public QObject {
    Q_OBJECT
private slots:
    void reservedCharactersAreEscaped() {
        QCOMPARE(escapedXml("a<b> & \"c\""), std::string("a&lt;b&gt; &amp; &quot;c&quot;"));
        QCOMPARE(escapedXml("Gl\xc3\xa4ser"), std::string("Gl\xc3\xa4ser"));
    }
    void bytesThatAreNoTextAreReplaced() { QCOMPARE(escapedXml("h\xff"), std::string("h\ufffd")); }
    void controlCharactersBecomeSpaces() {
        QCOMPARE(escapedXml(std::string_view("a\0b\nc\x1f", 6)), std::string("a b c "));
    }
};

RUBBLE_TEST(XmlTextTest)
#include "XmlTextTest.moc"
