// Tests core/io/system/Compression.cpp.
#include "core/io/system/Compression.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class CompressionTest : public QObject {
    Q_OBJECT
private slots:
    void bytesComeBack() {
        for (const std::string& bytes : {std::string(), std::string("stone"), std::string(100'000, 'a')}) {
            const std::string packed = compressed(bytes);
            QCOMPARE(*uncompressed(packed, bytes.size()), bytes);
            QCOMPARE(compressed(bytes), packed);
        }
        QVERIFY(compressed(std::string(100'000, 'a')).size() < 1000);
    }
    void everyOtherSizeAndEndIsRefused() {
        const std::string bytes = "stone, stone, brick, stone", packed = compressed(bytes);
        QVERIFY(!uncompressed(packed, bytes.size() - 1));
        QVERIFY(!uncompressed(packed, bytes.size() + 1));
        QVERIFY(!uncompressed(packed + '\0', bytes.size()));
        for (std::size_t size = 0; size < packed.size(); ++size)
            QVERIFY(!uncompressed(std::string_view(packed).substr(0, size), bytes.size()));
        QCOMPARE(uncompressed("stone", 5).error().message, std::string("its compressed part is damaged"));
    }
    void hugeSizesTakeNoMemory() {
        QCOMPARE(uncompressed(compressed("stone"), ~std::uint64_t{0}).error().message,
                 std::string("its size is wrong"));
    }
};

RUBBLE_TEST(CompressionTest)
#include "CompressionTest.moc"
