#include "core/io/text/TextBuffer.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class TextBufferTest : public QObject {
    Q_OBJECT
private slots:
    void shortAndLongTextsAreAppendedInOrder() {
        const std::string longText(20000, 'x');
        TextBuffer buffer;
        std::string expected;
        for (int k = 0; k < 3000; ++k) {
            buffer.append("wall");
            buffer.append(';');
            expected += "wall;";
        }
        buffer.append(longText);
        buffer.append('.');
        QCOMPARE(std::move(buffer).text(), expected + longText + '.');
    }

    void reservedBytesCountUpToTheSetEnd() {
        TextBuffer buffer(100);
        for (int k = 0; k < 2000; ++k) {
            char* at = buffer.reserve(24);
            *at++ = 'a';
            *at++ = 'b';
            buffer.setEnd(at);
        }
        const std::string text = std::move(buffer).text();
        QCOMPARE(text.size(), std::size_t{4000});
        QVERIFY(text.starts_with("abab") && text.ends_with("abab"));
    }
};

RUBBLE_TEST(TextBufferTest)
#include "TextBufferTest.moc"
