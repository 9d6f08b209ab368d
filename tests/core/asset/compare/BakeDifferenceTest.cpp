#include "core/asset/compare/BakeDifference.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <set>

namespace rubble {
namespace {

/// The unit square, half a metre deep, with a seed in the middle of each quarter.
Asset quarters() {
    return boxAsset(1, 5, PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.25, 0.75}}, {3, {0.75, 0.75}}}});
}

std::vector<PlacedSeeds::Seed>& seedsOf(Asset& asset) {
    return std::get<PlacedSeeds>(asset.pattern.layers[0].parameters).seeds;
}

BakeDifference between(const Asset& before, const Asset& after) { return differenceOf(*bake(before), *bake(after)); }

}  // namespace

class BakeDifferenceTest : public QObject {
    Q_OBJECT

private slots:
    void bakeEqualsItself() {
        for (const Asset& asset : {quarters(), ringAsset()}) {
            const BakeDifference difference = between(asset, asset);
            QVERIFY(difference.isEmpty());
            QCOMPARE(difference.sum().unchanged, std::size_t{bake(asset)->fragmentCount()});
        }
    }
    void assetIdIsIgnored() {
        Asset copy = quarters();
        copy.id = 77;
        QVERIFY(between(quarters(), copy).isEmpty());
    }
    void addedSeedReshapesItsNeighbours() {
        Asset after = quarters();
        seedsOf(after).push_back({4, {0.5, 0.5}});
        const BakeDifference difference = between(quarters(), after);
        QCOMPARE(difference.fragments.size(), std::size_t{5});
        QCOMPARE(difference.fragments[0].path, FragmentPath("5.4"));
        QVERIFY(difference.fragments[0].change == FragmentChange::Added && difference.fragments[0].before == kNone);
        QCOMPARE(difference.fragments[0].after, 4u);
        QCOMPARE(difference.fragments[0].volumeAfter, 0.0625);  // a diamond of 1/8 m², half a metre deep
        QCOMPARE(difference.count(FragmentChange::Moved), std::size_t{4});
        QCOMPARE(difference.levels.size(), std::size_t{1});
        QCOMPARE(difference.levels[0].before, std::size_t{4});
        QCOMPARE(difference.levels[0].after, std::size_t{5});
    }
    void removedSeedIsGone() {
        Asset after = quarters();
        seedsOf(after).erase(seedsOf(after).begin() + 1);
        const BakeDifference difference = between(quarters(), after);
        QVERIFY(difference.fragments[0].change == FragmentChange::Gone && difference.fragments[0].after == kNone);
        QCOMPARE(difference.fragments[0].path, FragmentPath("5.1"));
        QCOMPARE(difference.fragments[0].volumeBefore, 0.125);
    }
    void shiftIsMeasured() {
        Asset after = quarters();
        for (PlacedSeeds::Seed& seed : seedsOf(after)) seed.position.x += seed.position.x < 0.5 ? 0.1 : -0.1;
        QVERIFY(between(quarters(), after).isEmpty());  // the cells are what they were
        for (PlacedSeeds::Seed& seed : seedsOf(after)) seed.position.x += 0.1;
        const BakeDifference difference = between(quarters(), after);  // cut at x = 0.6
        QCOMPARE(difference.fragments.size(), std::size_t{4});
        for (const FragmentDifference& fragment : difference.fragments) {
            QVERIFY(fragment.change == FragmentChange::Moved);
            QVERIFY(std::abs(fragment.shift - 0.05) < 1e-12);
        }
    }
    void fragmentInPlaceCanBeReshaped() {
        Asset after = quarters();
        after.prism().depth = 1.0;
        const BakeDifference difference = between(quarters(), after);
        QCOMPARE(difference.count(FragmentChange::Reshaped), std::size_t{4});
        QCOMPARE(difference.fragments[0].shift, 0.0);
        QCOMPARE(difference.fragments[0].volumeAfter, 2.0 * difference.fragments[0].volumeBefore);
    }
    void levelsAreCountedSeparately() {
        Asset after = ringAsset();
        after.levels.clear();
        const BakeDifference difference = between(ringAsset(), after);
        QCOMPARE(difference.levels.size(), std::size_t{2});
        QCOMPARE(difference.levels[0].unchanged, difference.levels[0].before);
        QCOMPARE(difference.levels[1].changed[static_cast<int>(FragmentChange::Gone)], difference.levels[1].before);
        QVERIFY(difference.levels[1].before > 0 && difference.levels[1].after == 0);
    }
    void emptyBakesAreEqual() {
        const Bake whole = *bake(quarters());
        QCOMPARE(differenceOf({}, whole).count(FragmentChange::Added), std::size_t{4});
        QCOMPARE(differenceOf(whole, {}).count(FragmentChange::Gone), std::size_t{4});
        QVERIFY(differenceOf({}, {}).isEmpty());
    }
    void differenceIsSymmetric() {
        for (std::uint64_t randomSeed = 0; randomSeed < 40; ++randomSeed) {
            Random random(randomSeed);
            Asset before = boxAsset(1, 5, UniformScatter{static_cast<std::uint32_t>(2 + random.below(30))});
            Asset after = before;
            after.pattern.layers[0].parameters = UniformScatter{static_cast<std::uint32_t>(2 + random.below(30))};
            after.pattern.layers[0].overrides = {{.index = 0, .position = {random.unit(), random.unit()}}};
            const BakeDifference there = between(before, after), back = between(after, before);
            const auto isMirrored = [&](FragmentChange one, FragmentChange other) {
                return there.count(one) == back.count(other);
            };
            QVERIFY2(isMirrored(FragmentChange::Gone, FragmentChange::Added) &&
                         isMirrored(FragmentChange::Moved, FragmentChange::Moved) &&
                         isMirrored(FragmentChange::Reshaped, FragmentChange::Reshaped),
                     qPrintable(QString("random seed %1").arg(randomSeed)));
            std::set<FragmentPath> named;
            for (const FragmentDifference& fragment : there.fragments) named.insert(fragment.path);
            QCOMPARE(named.size(), there.fragments.size());
            QCOMPARE(there.sum().unchanged, back.sum().unchanged);
        }
    }
};

RUBBLE_TEST(BakeDifferenceTest)

}  // namespace rubble

#include "BakeDifferenceTest.moc"
