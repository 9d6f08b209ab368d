#include "core/base/KeySort.h"
#include "core/base/Random.h"

#include <QTest>

#include <algorithm>
#include <vector>

using namespace rubble;

class KeySortTest : public QObject {
    Q_OBJECT
private slots:
    void anEntryGivesBackWhatItWasMadeOf() {
        QCOMPARE(keyOf(keyed(0xfffffffeu, 7)), 0xfffffffeu);
        QCOMPARE(indexOf(keyed(3, 0xfffffffdu)), 0xfffffffdu);
    }

    /// Of all widths and lengths, keys that are often equal among them.
    void entriesStandInTheOrderOfAStableSort() {
        Random random(20);
        for (int run = 0; run < 2000; ++run) {
            const int width = run % 33;
            const auto most = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
            std::vector<Keyed> entries(static_cast<std::size_t>(random.unit() * 300)), other(entries.size());
            for (std::uint32_t k = 0; k < entries.size(); ++k)
                entries[k] = keyed(static_cast<std::uint32_t>(random.unit() * 4294967296.0) & most, k);
            std::vector<Keyed> expected = entries;
            std::ranges::stable_sort(expected, {}, keyOf);
            const std::span<Keyed> sorted = sortByKey(entries, other, width);
            QVERIFY2(std::ranges::equal(sorted, expected), qPrintable(QString("run %1").arg(run)));
        }
    }

    void bitsAboveTheWidthDoNotCount() {
        std::vector<Keyed> entries{keyed(0x101, 0), keyed(0x000, 1)}, other(2);
        const std::span<Keyed> sorted = sortByKey(entries, other, 8);
        QCOMPARE(indexOf(sorted[0]), 1u);
        QCOMPARE(indexOf(sorted[1]), 0u);
    }
};

QTEST_APPLESS_MAIN(KeySortTest)
#include "KeySortTest.moc"
