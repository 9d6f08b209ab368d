#include "editor/commands/Resizing.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

class ResizingTest : public QObject {
    Q_OBJECT
private slots:
    void scalesOutlineDepthAndPlacedSeedsAboutTheCentre() {
        Asset asset = boxAsset(2, 3, PlacedSeeds{{{0, {0.5, 0.25}}}});
        asset.prism.outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, {}};
        const Asset scaled = resized(asset, {4.0, 2.0, 0.75});
        QCOMPARE(sizeOf(scaled), Vec3(4.0, 2.0, 0.75));
        QCOMPARE(scaled.prism.outline.outer[0], Vec2(-1.0, -0.5));
        QCOMPARE(std::get<PlacedSeeds>(scaled.pattern.layers[0].parameters).seeds[0].position, Vec2(0.0, 0.0));
    }
    void scalesMovedSeedsButNotDeletedOnes() {
        Asset asset = boxAsset(2, 3, UniformScatter{.count = 4});
        asset.prism.outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}};
        asset.pattern.layers[0].overrides = {{.index = 0, .position = {1.5, 1.0}}, {.index = 1, .isDeleted = true}};
        const auto overrides = resized(asset, {4.0, 2.0, 1.0}).pattern.layers[0].overrides;
        QCOMPARE(overrides[0].position, Vec2(2.0, 1.0));
        QVERIFY(overrides[1].isDeleted && overrides[1].position == Vec2(0.0, 0.0));
    }
};

RUBBLE_TEST(ResizingTest)
#include "ResizingTest.moc"
