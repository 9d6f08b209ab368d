#include "core/base/UninitializedVector.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cstdint>
#include <numeric>

using namespace rubble;

class UninitializedVectorTest : public QObject {
    Q_OBJECT
private slots:
    void valuesSurviveGrowthOntoHugePages() {
        constexpr std::size_t kCount = kMinHugePageBytes / sizeof(std::uint64_t);
        UninitializedVector<std::uint64_t> values(kCount - 1);
        std::iota(values.begin(), values.end(), 0u);
        for (std::size_t i = values.size(); i < 3 * kCount; ++i) values.push_back(i);
        for (std::size_t i = 0; i < values.size(); ++i) QCOMPARE(values[i], i);
        values.resize(1);
        values.shrink_to_fit();
        QCOMPARE(values, UninitializedVector<std::uint64_t>(1, 0u));
    }
    void hugePageMemoryIsAligned() {
        void* const memory = allocateHugePages(kMinHugePageBytes + 1);
        QCOMPARE(reinterpret_cast<std::uintptr_t>(memory) % (std::size_t{1} << 21), std::uintptr_t{0});
        freeHugePages(memory);
    }
};

RUBBLE_TEST(UninitializedVectorTest)
#include "UninitializedVectorTest.moc"
