#include "core/base/Utf8.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class Utf8Test : public QObject {
    Q_OBJECT
private slots:
    void wellFormedTextIsAccepted() {
        for (const char* text : {"", "wall", "\x7f", "M\xc3\xa4uerchen", "\xc2\x80\xdf\xbf", "\xe0\xa0\x80\xef\xbf\xbf",
                                 "\xed\x9f\xbf\xee\x80\x80", "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf"})
            QVERIFY2(isUtf8(text), text);
        QVERIFY(isUtf8(std::string_view("\0", 1)));
    }
    void malformedTextIsRejected_data() {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const char* text) { QTest::newRow(name) << QByteArray(text); };
        row("Latin-1", "M\xe4uer");
        row("continuation alone", "a\x80");
        row("overlong of two", "\xc0\xaf");
        row("overlong of three", "\xe0\x9f\xbf");
        row("overlong of four", "\xf0\x8f\xbf\xbf");
        row("surrogate", "\xed\xa0\x80");
        row("above the last", "\xf4\x90\x80\x80");
        row("lead above the last", "\xf5\x80\x80\x80");
        row("cut after one of two", "a\xc3");
        row("cut after two of three", "\xe2\x82");
        row("cut after three of four", "\xf0\x9f\x98");
    }
    void malformedTextIsRejected() {
        QFETCH(QByteArray, text);
        QVERIFY(!isUtf8(text.toStdString()));
    }
    void malformedBytesAreReplaced() {
        QCOMPARE(wellFormed("M\u00e4uer"), std::string("M\u00e4uer"));
        QCOMPARE(wellFormed("h\xff\xc3(\xed\xa0\x80"), std::string("h\ufffd\ufffd(\ufffd\ufffd\ufffd"));
    }
};

RUBBLE_TEST(Utf8Test)
#include "Utf8Test.moc"
