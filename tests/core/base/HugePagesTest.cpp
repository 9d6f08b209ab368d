#include "core/base/HugePages.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <cstdint>
#include <cstring>

using namespace rubble;

class HugePagesTest : public QObject {
    Q_OBJECT
private slots:
    void memoryIsAlignedAndUsable() {
        for (const std::size_t bytes : {kMinHugePageBytes, kMinHugePageBytes + 1, 3 * kMinHugePageBytes - 7}) {
            void* const memory = allocateHugePages(bytes);
            QCOMPARE(reinterpret_cast<std::uintptr_t>(memory) % (std::uintptr_t{1} << 21), std::uintptr_t{0});
            std::memset(memory, 0x5a, bytes);
            QCOMPARE(static_cast<unsigned char*>(memory)[bytes - 1], static_cast<unsigned char>(0x5a));
            freeHugePages(memory);
        }
    }
};

RUBBLE_TEST(HugePagesTest)
#include "HugePagesTest.moc"
