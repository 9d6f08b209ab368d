#include "core/io/text/Base64.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class Base64Test : public QObject {
    Q_OBJECT
private slots:
    /// Source: RFC 4648, section 10.
    void vectorsOfTheStandard() {
        const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"}};
        for (const auto& [bytes, text] : vectors) {
            QCOMPARE(base64(bytes), text);
            QCOMPARE(*base64Decoded(text), bytes);
        }
    }
    void allBytesReturn() {
        std::string bytes;
        for (int k = 0; k < 256; ++k) bytes += static_cast<char>(k);
        QVERIFY(base64Decoded(base64(bytes)) == bytes);
    }
    void otherCharactersAreRejected() { QVERIFY(!base64Decoded("Zm9 v") && !base64Decoded("Zm9=v")); }
};

RUBBLE_TEST(Base64Test)
#include "Base64Test.moc"
