#include "core/fracture/pattern/SeedEdits.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

Pattern twoLayers() {
    return {{{.id = 3, .parameters = UniformScatter{.count = 5}},
             {.id = 4, .parameters = PlacedSeeds{{{0, {0.0, 0.0}}, {2, {1.0, 1.0}}}}}}};
}

}  // namespace

class SeedEditsTest : public QObject {
    Q_OBJECT
private slots:
    void scatteredSeedsGetOneOverrideEach() {
        Pattern pattern = twoLayers();
        moveSeed(pattern, {3, 4}, {0.5, 0.5});
        deleteSeed(pattern, {3, 1});
        moveSeed(pattern, {3, 4}, {0.25, 0.5});
        const std::vector<SeedOverride> expected = {{.index = 1, .isDeleted = true},
                                                    {.index = 4, .position = {0.25, 0.5}}};
        QVERIFY(pattern.layers[0].overrides == expected);
    }
    void placedSeedsAreChangedThemselves() {
        Pattern pattern = twoLayers();
        moveSeed(pattern, {4, 2}, {2.0, 2.0});
        deleteSeed(pattern, {4, 0});
        QVERIFY((std::get<PlacedSeeds>(pattern.layers[1].parameters) == PlacedSeeds{{{2, {2.0, 2.0}}}}));
        QVERIFY(pattern.layers[1].overrides.empty());
        QVERIFY((placeSeed(pattern.layers[1], {3.0, 3.0}) == SeedId{4, 3}));
    }
    void seedsInSpaceHaveHeights() {
        Pattern pattern = twoLayers();
        moveSeed(pattern, {3, 4}, Vec3(0.5, 0.5, 0.75));
        moveSeed(pattern, {4, 2}, Vec3(2.0, 2.0, -1.0));
        QVERIFY((placeSeed(pattern.layers[1], Vec3(3.0, 3.0, 4.0)) == SeedId{4, 3}));
        const std::vector<SeedOverride> expected = {{.index = 4, .position = {0.5, 0.5}, .height = 0.75}};
        QVERIFY(pattern.layers[0].overrides == expected);
        QVERIFY((std::get<PlacedSeeds>(pattern.layers[1].parameters) ==
                 PlacedSeeds{{{0, {0.0, 0.0}}, {2, {2.0, 2.0}, -1.0}, {3, {3.0, 3.0}, 4.0}}}));
    }
    void restoredSeedHasNoOverride() {
        Pattern pattern = twoLayers();
        moveSeed(pattern, {3, 4}, {0.5, 0.5});
        deleteSeed(pattern, {3, 1});
        restoreSeed(pattern, {3, 4});
        QVERIFY((pattern.layers[0].overrides == std::vector<SeedOverride>{{.index = 1, .isDeleted = true}}));
        restoreSeed(pattern, {3, 1});
        restoreSeed(pattern, {3, 2});
        restoreSeed(pattern, {4, 2});
        restoreSeed(pattern, {9, 0});
        QVERIFY(pattern == twoLayers());
    }
    void missingLayerIsIgnored() {
        Pattern pattern = twoLayers();
        moveSeed(pattern, {9, 0}, {0.5, 0.5});
        deleteSeed(pattern, {9, 0});
        moveSeed(pattern, {4, 1}, {0.5, 0.5});
        QVERIFY(pattern == twoLayers());
    }
};

RUBBLE_TEST(SeedEditsTest)
#include "SeedEditsTest.moc"
