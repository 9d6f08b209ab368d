#include "core/base/DisjointSets.h"

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace rubble;

class DisjointSetsTest : public QObject {
    Q_OBJECT
private slots:
    void eachNumberBeginsAlone() {
        DisjointSets sets(3);
        QCOMPARE(sets.roots(), (std::vector<std::uint32_t>{0, 1, 2}));
    }
    void smallestMemberIsTheRoot() {
        DisjointSets sets(6);
        QVERIFY(sets.merge(5, 3));
        QVERIFY(sets.merge(3, 4));
        QVERIFY(!sets.merge(4, 5));
        QCOMPARE(sets.rootOf(5), 3u);
        QVERIFY(sets.merge(4, 1));
        QCOMPARE(sets.roots(), (std::vector<std::uint32_t>{0, 1, 2, 1, 1, 1}));
    }
    void threadsMergeToTheSameSets() {
        constexpr std::uint32_t kCount = 20'000;
        Random random(5);
        std::vector<std::array<std::uint32_t, 2>> pairs(kCount * 3 / 4);
        for (auto& [a, b] : pairs) {
            a = static_cast<std::uint32_t>(random.below(kCount));
            b = static_cast<std::uint32_t>(random.below(kCount));
        }
        DisjointSets one(kCount), shared(kCount);
        for (const auto& [a, b] : pairs) one.merge(a, b);
        forEachIndex(64, 4, [&](std::size_t part) {
            const IndexRange range = chunkRange(pairs.size(), part, 64);
            for (std::size_t k = range.begin; k < range.end; ++k) shared.mergeShared(pairs[k][0], pairs[k][1]);
        });
        QVERIFY(one.roots() == shared.roots());
    }
    void rootCanBeGiven() {
        DisjointSets sets(3);
        sets.mergeInto(2, 0);
        QCOMPARE(sets.roots(), (std::vector<std::uint32_t>{2, 1, 2}));
    }
    /// Against sets that are renumbered one by one.
    void setsAreThoseOfARenumberedList() {
        for (std::uint64_t randomSeed = 0; randomSeed < 500; ++randomSeed) {
            Random random(randomSeed);
            const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random.below(end)); };
            const std::uint32_t count = 1 + below(40);
            DisjointSets sets(count);
            std::vector<std::uint32_t> expected = DisjointSets(count).roots();
            for (std::uint32_t k = below(2 * count); k > 0; --k) {
                const std::uint32_t a = below(count), b = below(count);
                const std::uint32_t kept = std::min(expected[a], expected[b]),
                                    gone = std::max(expected[a], expected[b]);
                QCOMPARE(sets.merge(a, b), kept != gone);
                std::ranges::replace(expected, gone, kept);
            }
            QVERIFY2(sets.roots() == expected, qPrintable(QString("random seed %1").arg(randomSeed)));
        }
    }
};

RUBBLE_TEST(DisjointSetsTest)
#include "DisjointSetsTest.moc"
