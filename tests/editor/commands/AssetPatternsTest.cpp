#include "editor/commands/AssetPatterns.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// An asset with one level, a fragment with a pattern of its own, and one that is kept whole.
Asset wall() {
    Asset asset = boxAsset(2, 3, UniformScatter{.count = 4});
    asset.levels = {{.pattern = {{{.id = 5, .parameters = UniformScatter{.count = 2}}}}}};
    asset.leaves = {{"3.1", Level{.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 9}}}}}},
                    {"3.2", std::nullopt}};
    return asset;
}

}  // namespace

class AssetPatternsTest : public QObject {
    Q_OBJECT
private slots:
    void wholeLevelsAndFragmentsAreCounted() {
        QCOMPARE(patternCount(wall()), std::size_t{4});
        const Asset asset = wall();
        QCOMPARE(patternAt(asset, 0), &asset.pattern);
        QCOMPARE(patternAt(asset, 1), &asset.levels[0].pattern);
        QCOMPARE(patternAt(asset, 2), &asset.leaves[0].level->pattern);
        QVERIFY(!patternAt(asset, 3) && !levelAt(asset, 0));
    }
    void fragmentHasItsOwnPatternOrThatOfItsLevel() {
        QCOMPARE(patternIndexFor(wall(), ""), std::size_t{0});
        QCOMPARE(patternIndexFor(wall(), "3.0"), std::size_t{1});
        QCOMPARE(patternIndexFor(wall(), "3.1"), std::size_t{2});
        QVERIFY(hasOwnPattern(wall(), "3.1") && !hasOwnPattern(wall(), "3.0") && !hasOwnPattern(wall(), "3.2"));
    }
    void minimumVolumeIsSetPerLevel() {
        Asset asset = wall();
        setMinimumVolume(asset, 1, 0.5);
        setMinimumVolume(asset, 2, 0.25);
        setMinimumVolume(asset, 3, 0.125);  // kept whole: no level
        QCOMPARE(asset.levels[0].minimumVolume, 0.5);
        QCOMPARE(asset.leaves[0].level->minimumVolume, 0.25);
        QVERIFY(!asset.leaves[1].level);
    }
    void removesLevelsAndOwnPatterns() {
        Asset asset = wall();
        removeLevelAt(asset, 2);
        QCOMPARE(asset.leaves.size(), std::size_t{1});
        removeLevelAt(asset, 1);
        QVERIFY(asset.levels.empty());
        removeLevelAt(asset, 0);  // the whole asset stays
        QCOMPARE(patternCount(asset), std::size_t{2});
    }
    void namesTellWhatIsFractured() {
        QCOMPARE(patternName(wall(), 0), "Whole asset");
        QCOMPARE(patternName(wall(), 1), "Fragments, level 1");
        QCOMPARE(patternName(wall(), 2), "Fragment 3.1");
        QCOMPARE(patternName(wall(), 3), "Fragment 3.2, kept whole");
    }
};

RUBBLE_TEST(AssetPatternsTest)
#include "AssetPatternsTest.moc"
