#include "editor/canvas/painting/MovedCells.h"

#include "core/fracture/pattern/SeedEdits.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <functional>

using namespace rubble;

namespace {

constexpr std::uint32_t kScattered = 3, kPlaced = 4;  // layers

Asset wallWithMovedSeed() {
    Asset asset = boxAsset(2, kScattered, UniformScatter{.count = 20});
    asset.prism().outline = unitSquare();
    asset.pattern.layers.push_back({.id = kPlaced, .parameters = PlacedSeeds{{{0, {0.2, 0.3}}, {5, {0.7, 0.6}}}}});
    moveSeed(asset.pattern, {kScattered, 7}, {0.5, 0.5});
    deleteSeed(asset.pattern, {kScattered, 3});
    return asset;
}

std::shared_ptr<const DrawablePattern> shown(const Asset& asset) {
    auto baked = std::make_shared<BakedPattern>();
    baked->asset = std::make_shared<const Asset>(asset);
    baked->seeds = *seedsOf(asset.pattern, asset.prism().outline);
    baked->triangulation = *triangulate(baked->seeds.positions);
    baked->partition = *voronoiPartition(asset.prism().outline, baked->triangulation);
    return std::make_shared<const DrawablePattern>(baked);
}

/// The moved seeds after a change of the asset.
std::optional<std::vector<MovedSeed>> movedBy(const std::function<void(Asset&)>& change) {
    const Asset before = wallWithMovedSeed();
    Asset now = before;
    change(now);
    return movedSeeds(*shown(before), now);
}

}  // namespace

class MovedCellsTest : public QObject {
    Q_OBJECT
private slots:
    void movedSeedsAreFound() {
        const std::shared_ptr<const DrawablePattern> before = shown(wallWithMovedSeed());
        for (const SeedId seed : {SeedId{kScattered, 7}, SeedId{kScattered, 11}, SeedId{kPlaced, 5}}) {
            Asset now = wallWithMovedSeed();
            moveSeed(now.pattern, seed, {0.25, 0.75});
            const auto moved = movedSeeds(*before, now);
            QCOMPARE(moved->size(), std::size_t{1});
            QCOMPARE(moved->front().seed, before->find(seed));
            QCOMPARE(moved->front().position, Vec2(0.25, 0.75));
        }
    }
    void otherChangesMoveNoSeeds() {
        QCOMPARE(movedBy([](Asset&) {})->size(), std::size_t{0});
        QCOMPARE(movedBy([](Asset& asset) { asset.name = "gable"; })->size(), std::size_t{0});
        QCOMPARE(movedBy([](Asset& asset) {
                     moveSeed(asset.pattern, {kScattered, 900}, {0.1, 0.1});
                 })->size(),
                 std::size_t{0});  // there is no such seed
    }
    void largerChangesHaveNoMovedPart() {
        QVERIFY(!movedBy([](Asset& asset) { deleteSeed(asset.pattern, {kScattered, 7}); }));
        QVERIFY(!movedBy([](Asset& asset) { deleteSeed(asset.pattern, {kScattered, 9}); }));
        QVERIFY(!movedBy([](Asset& asset) { restoreSeed(asset.pattern, {kScattered, 3}); }));
        QVERIFY(!movedBy([](Asset& asset) { restoreSeed(asset.pattern, {kScattered, 7}); }));
        QVERIFY(!movedBy([](Asset& asset) { deleteSeed(asset.pattern, {kPlaced, 5}); }));
        QVERIFY(!movedBy([](Asset& asset) { placeSeed(asset.pattern.layers[1], {0.4, 0.4}); }));
        QVERIFY(!movedBy([](Asset& asset) { asset.pattern.layers[0].randomSeed = 99; }));
        QVERIFY(!movedBy([](Asset& asset) { asset.pattern.layers[0].isOn = false; }));
        QVERIFY(!movedBy([](Asset& asset) { asset.pattern.layers.pop_back(); }));
        QVERIFY(!movedBy([](Asset& asset) { asset.prism().outline = lShape(); }));
    }
    void relaxedPatternsHaveNoMovedPart() {
        Asset before = wallWithMovedSeed();
        before.pattern.layers.push_back({.id = 5, .parameters = LloydRelaxation{}});
        Asset now = before;
        moveSeed(now.pattern, {kScattered, 7}, {0.4, 0.5});
        QVERIFY(!movedSeeds(*shown(before), now));
    }
    void movedPartReplacesChangedSeeds() {
        const std::shared_ptr<const DrawablePattern> before = shown(wallWithMovedSeed());
        Asset now = wallWithMovedSeed();
        moveSeed(now.pattern, {kPlaced, 0}, {0.22, 0.3});
        MovedCells cells(before);
        const std::shared_ptr<const MovedPart> part = cells.movedPart(now);
        const std::shared_ptr<const DrawablePattern> after = shown(now);
        const std::uint32_t seed = part->pattern->find({kPlaced, 0});
        QVERIFY(part->isShown[seed]);
        QVERIFY(part->replaces(before->find({kPlaced, 0})));
        const std::uint32_t piece = part->pattern->partition().pieceOfSeed[seed];
        const std::uint32_t whole = after->partition().pieceOfSeed[after->find({kPlaced, 0})];
        QVERIFY(qFuzzyCompare(part->pattern->area(piece), after->area(whole)));
        QCOMPARE(part->pattern->neighbours(piece).size(), after->neighbours(whole).size());
        QCOMPARE(part->pattern->fragmentId(piece), after->fragmentId(whole));
        const Box2 box = part->changed, difference = differenceBox(*before, *after);
        QVERIFY(box.min.x <= difference.min.x && box.min.y <= difference.min.y);
        QVERIFY(box.max.x >= difference.max.x && box.max.y >= difference.max.y);
    }
    void unchangedPatternsHaveNoMovedPart() {
        MovedCells cells(shown(wallWithMovedSeed()));
        QVERIFY(!cells.movedPart(wallWithMovedSeed()));
    }
};

RUBBLE_TEST(MovedCellsTest)
#include "MovedCellsTest.moc"
