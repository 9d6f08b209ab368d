#include "core/base/RadixSort.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <vector>

using namespace rubble;

class RadixSortTest : public QObject {
    Q_OBJECT
private slots:
    void keyAndIndexAreRecovered() {
        QCOMPARE(keyOf(keyedIndex(0xfffffffeu, 7)), 0xfffffffeu);
        QCOMPARE(indexOf(keyedIndex(3, 0xfffffffdu)), 0xfffffffdu);
    }

    /// All widths and lengths, with many equal keys.
    void sortEqualsStableSort() {
        const std::uint64_t seed = 20;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int run = 0; run < 2000; ++run) {
            const int width = run % 33;
            const auto most = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
            std::vector<KeyedIndex> entries(static_cast<std::size_t>(random.unit() * 300)), other(entries.size());
            for (std::uint32_t k = 0; k < entries.size(); ++k)
                entries[k] = keyedIndex(static_cast<std::uint32_t>(random.unit() * 4294967296.0) & most, k);
            std::vector<KeyedIndex> expected = entries;
            std::ranges::stable_sort(expected, {}, keyOf);
            const std::span<KeyedIndex> sorted = radixSortByKey(entries, other, width);
            QVERIFY2(std::ranges::equal(sorted, expected), qPrintable(QString("run %1").arg(run)));
        }
    }

    void bitsAboveWidthAreIgnored() {
        std::vector<KeyedIndex> entries{keyedIndex(0x101, 0), keyedIndex(0x000, 1)}, other(2);
        const std::span<KeyedIndex> sorted = radixSortByKey(entries, other, 8);
        QCOMPARE(indexOf(sorted[0]), 1u);
        QCOMPARE(indexOf(sorted[1]), 0u);
    }
};

RUBBLE_TEST(RadixSortTest)
#include "RadixSortTest.moc"
