#include "editor/commands/AssetPatterns.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// An asset with one level, a fragment with a pattern of its own, and one that is kept intact.
Asset wallWithLeaves() {
    Asset asset = boxAsset(2, 3, UniformScatter{.count = 4});
    asset.levels = {{.pattern = {{{.id = 5, .parameters = UniformScatter{.count = 2}}}}}};
    asset.fragmentLevels = {{"3.1", Level{.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 9}}}}}},
                            {"3.2", std::nullopt}};
    return asset;
}

}  // namespace

class AssetPatternsTest : public QObject {
    Q_OBJECT
private slots:
    void wholeLevelsAndFragmentsAreCounted() {
        QCOMPARE(patternCount(wallWithLeaves()), std::size_t{4});
        const Asset asset = wallWithLeaves();
        QCOMPARE(patternAt(asset, 0), &asset.pattern);
        QCOMPARE(patternAt(asset, 1), &asset.levels[0].pattern);
        QCOMPARE(patternAt(asset, 2), &asset.fragmentLevels[0].level->pattern);
        QVERIFY(!patternAt(asset, 3) && !levelAt(asset, 0));
    }
    void fragmentHasItsOwnPatternOrThatOfItsLevel() {
        QCOMPARE(patternIndexFor(wallWithLeaves(), ""), std::size_t{0});
        QCOMPARE(patternIndexFor(wallWithLeaves(), "3.0"), std::size_t{1});
        QCOMPARE(patternIndexFor(wallWithLeaves(), "3.1"), std::size_t{2});
        QVERIFY(hasOwnPattern(wallWithLeaves(), "3.1") && !hasOwnPattern(wallWithLeaves(), "3.0") &&
                !hasOwnPattern(wallWithLeaves(), "3.2"));
    }
    void minimumVolumeIsSetPerLevel() {
        Asset asset = wallWithLeaves();
        setMinimumVolume(asset, 1, 0.5);
        setMinimumVolume(asset, 2, 0.25);
        setMinimumVolume(asset, 3, 0.125);  // kept intact: no level
        QCOMPARE(asset.levels[0].minimumVolume, 0.5);
        QCOMPARE(asset.fragmentLevels[0].level->minimumVolume, 0.25);
        QVERIFY(!asset.fragmentLevels[1].level);
    }
    void thresholdIsSetPerLevel() {
        Asset asset = wallWithLeaves();
        setLevelThreshold(asset, 1, 5.0);
        setLevelThreshold(asset, 2, 2.5);
        setLevelThreshold(asset, 3, 1.25);  // kept intact: no level
        QCOMPARE(asset.levels[0].threshold, std::optional(5.0));
        QCOMPARE(asset.fragmentLevels[0].level->threshold, std::optional(2.5));
        setBondStrength(asset, 1, 3.0);
        setBondStrength(asset, 2, 2.0);
        setBondStrength(asset, 3, 1.5);  // kept intact: no level
        QVERIFY(levelAt(asset, 1)->bondStrength == 3.0 && levelAt(asset, 2)->bondStrength == 2.0);
        QVERIFY(levelAt(asset, 3) == nullptr);
        setLevelThreshold(asset, 1, std::nullopt);
        QVERIFY(!asset.levels[0].threshold);
    }
    void removesLevelsAndOwnPatterns() {
        Asset asset = wallWithLeaves();
        removeLevelAt(asset, 2);
        QCOMPARE(asset.fragmentLevels.size(), std::size_t{1});
        removeLevelAt(asset, 1);
        QVERIFY(asset.levels.empty());
        removeLevelAt(asset, 0);  // the whole asset stays
        QCOMPARE(patternCount(asset), std::size_t{2});
    }
    void namesTellWhatIsFractured() {
        QCOMPARE(patternName(wallWithLeaves(), 0), "Intact asset");
        QCOMPARE(patternName(wallWithLeaves(), 1), "Fragments, level 1");
        QCOMPARE(patternName(wallWithLeaves(), 2), "Fragment 3.1");
        QCOMPARE(patternName(wallWithLeaves(), 3), "Fragment 3.2, kept intact");
    }
};

RUBBLE_TEST(AssetPatternsTest)
#include "AssetPatternsTest.moc"
