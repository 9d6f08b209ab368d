#include "core/base/RawVector.h"

#include <QTest>

#include <cstdint>
#include <numeric>

using namespace rubble;

class RawVectorTest : public QObject {
    Q_OBJECT
private slots:
    void valuesStayAsAVectorGrowsOntoLargePages() {
        constexpr std::size_t kCount = kLeastForLargePages / sizeof(std::uint64_t);
        RawVector<std::uint64_t> values(kCount - 1);
        std::iota(values.begin(), values.end(), 0u);
        for (std::size_t i = values.size(); i < 3 * kCount; ++i) values.push_back(i);
        for (std::size_t i = 0; i < values.size(); ++i) QCOMPARE(values[i], i);
        values.resize(1);
        values.shrink_to_fit();
        QCOMPARE(values, RawVector<std::uint64_t>(1, 0u));
    }
    void largeMemoryIsAlignedToItsPages() {
        void* const memory = allocateLarge(kLeastForLargePages + 1);
        QCOMPARE(reinterpret_cast<std::uintptr_t>(memory) % (std::size_t{1} << 21), std::uintptr_t{0});
        freeLarge(memory);
    }
};

QTEST_APPLESS_MAIN(RawVectorTest)
#include "RawVectorTest.moc"
