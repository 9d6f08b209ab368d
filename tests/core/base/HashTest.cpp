#include "core/base/Hash.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class HashTest : public QObject {
    Q_OBJECT
private slots:
    void hashIsThatOfXxh3() {  // the 128-bit value that the XXH3 specification gives for no input
        QCOMPARE(contentHash("").hex(), "99aa06d3014798d86001c324468d497f");
    }
    void partsHashAsTheWhole() {
        Hasher parts;
        parts.add(std::string_view("rub"));
        parts.add(std::string_view("ble"));
        QVERIFY(parts.digest() == contentHash("rubble"));
        QVERIFY(parts.digest() != contentHash("Rubble"));
    }
    void numbersAreLittleEndianBytes() {
        Hasher number, bytes, real;
        number.add(std::uint64_t{0x0807060504030201});
        bytes.add(std::string_view("\1\2\3\4\5\6\7\10"));
        QVERIFY(number.digest() == bytes.digest());
        real.add(1.0);
        Hasher bits;
        bits.add(std::uint64_t{0x3ff0000000000000});
        QVERIFY(real.digest() == bits.digest());
    }
    void textReadsBack() {
        const ContentHash hash{0x0123456789abcdef, 0xf};
        QCOMPARE(hash.hex(), "0123456789abcdef000000000000000f");
        QVERIFY(parseContentHash(hash.hex()) == hash);
    }
    void otherTextsAreRejected() {
        QVERIFY(!parseContentHash(""));
        QVERIFY(!parseContentHash("0123456789abcdef000000000000000"));
        QVERIFY(!parseContentHash("0123456789abcdef000000000000000g"));
        QVERIFY(!parseContentHash("0123456789abcde-0000000000000000"));
        QVERIFY(!parseContentHash("0123456789abcdef000000000000000f0"));
    }
};

RUBBLE_TEST(HashTest)
#include "HashTest.moc"
