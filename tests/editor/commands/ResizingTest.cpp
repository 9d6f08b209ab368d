#include "editor/commands/Resizing.h"

#include "core/geometry/polygon/PolygonFaults.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

class ResizingTest : public QObject {
    Q_OBJECT
private slots:
    void scalesOutlineDepthAndPlacedSeedsAboutTheCentre() {
        Asset asset = boxAsset(2, 3, PlacedSeeds{{{0, {0.5, 0.25}}}});
        asset.prism().outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, {}};
        const Asset scaled = resized(asset, {4.0, 2.0, 0.75});
        QCOMPARE(sizeOf(scaled), Vec3(4.0, 2.0, 0.75));
        QCOMPARE(scaled.prism().outline.outer[0], Vec2(-1.0, -0.5));
        QCOMPARE(std::get<PlacedSeeds>(scaled.pattern.layers[0].parameters).seeds[0].position, Vec2(0.0, 0.0));
    }
    /// Along z, about the middle of the mesh.
    void scalesHeightsInMeshes() {
        Asset asset = meshAsset(transformed(cubes({{0, 0, 0}}), Mat3(2.0)), 5);
        asset.pattern.layers[0].parameters = PlacedSeeds{{{.index = 0, .position = {1.0, 1.0}, .height = 1.5}}};
        asset.pattern.layers[0].overrides = {{.index = 1, .position = {1.0, 1.0}, .height = 0.5}};
        asset.pattern.layers.push_back({.id = 9, .parameters = RadialPattern{.centreHeight = 2.0}});
        const Pattern scaled = resized(asset, {2.0, 2.0, 4.0}).pattern;
        QCOMPARE(std::get<PlacedSeeds>(scaled.layers[0].parameters).seeds[0].height, 2.0);
        QCOMPARE(scaled.layers[0].overrides[0].height, 0.0);
        QCOMPARE(std::get<RadialPattern>(scaled.layers[1].parameters).centreHeight, 3.0);
    }
    void scalesMovedSeedsButNotDeletedOnes() {
        Asset asset = boxAsset(2, 3, UniformScatter{.count = 4});
        asset.prism().outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}};
        asset.pattern.layers[0].overrides = {{.index = 0, .position = {1.5, 1.0}}, {.index = 1, .isDeleted = true}};
        const auto overrides = resized(asset, {4.0, 2.0, 1.0}).pattern.layers[0].overrides;
        QCOMPARE(overrides[0].position, Vec2(2.0, 1.0));
        QVERIFY(overrides[1].isDeleted && overrides[1].position == Vec2(0.0, 0.0));
    }
    /// The outline that seeds were scattered in before another one was entered may be much larger or smaller.
    void outlineOfScatterThatBecomesTooThinIsDropped() {
        Asset asset = boxAsset(2, 3, UniformScatter{});
        asset.prism().outline = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}};
        asset.pattern.layers[0].scatteredIn = Polygon{{{0.0, 0.0}, {1e-55, 0.0}, {1e-55, 1.0}, {0.0, 1.0}}, {}};
        for (const double width : {1e-3, 1e3, 1e-4, 1.0, 1e-5}) {
            asset = resized(asset, {width, 1.0, 0.5});
            const std::optional<Polygon>& kept = asset.pattern.layers[0].scatteredIn;
            QVERIFY(!kept || validated(Polygon(*kept)).hasValue());
        }
    }
    void scalesStrokesAndHeightsOfBonds() {
        Asset asset = boxAsset(2, 3, PlacedSeeds{});
        asset.prism().outline = {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, {}};
        asset.bonding.strokes = {{.radius = 0.2, .points = {{0.5, 0.25}, {2.0, 1.0}}}};
        asset.bonding.heightStrengths = {{.height = 0.25}, {.height = 1.0, .factor = 2.0}};
        const Bonding scaled = resized(asset, {4.0, 2.0, 0.75}).bonding;
        QCOMPARE(scaled.strokes[0].points, (std::vector<Vec2>{{0.0, 0.0}, {3.0, 1.5}}));
        QCOMPARE(scaled.strokes[0].radius, 0.2);
        QCOMPARE(scaled.heightStrengths, (std::vector<HeightStrength>{{.height = 0.5}, {2.0, 2.0}}));
        QCOMPARE(resized(asset, {2.0, 1.0, 3.0}).bonding, asset.bonding);
    }
    void resizingStretchesOutlineSeedsAndUvs() {
        const Asset wall = fullProject().assets[0];
        const Vec3 size = sizeOf(wall);
        const Asset wide = resized(wall, {size.x * 2.0, size.y, size.z});
        QCOMPARE(sizeOf(wide).x, size.x * 2.0);
        QVERIFY(validated(wide.prism()).hasValue());
        const auto uOf = [](const Asset& asset, Vec2 at) {
            const auto& c = asset.surface->front.map.coefficients;
            return c[0] * at.x + c[1] * at.y + c[2];
        };
        for (std::size_t k = 0; k < wall.prism().outline.outer.size(); ++k) {
            QCOMPARE(uOf(wide, wide.prism().outline.outer[k]), uOf(wall, wall.prism().outline.outer[k]));
        }
        const auto placedSeeds = [](const Asset& asset) {
            return std::get<PlacedSeeds>(asset.pattern.layers[2].parameters).seeds;
        };
        const double middle = sizeOf(wall).x / 2.0 + boundsOf(wall.prism().outline.outer).min.x;
        QCOMPARE(placedSeeds(wide)[0].position.x - middle, 2.0 * (placedSeeds(wall)[0].position.x - middle));
        QCOMPARE(resized(wall, size), wall);
    }
};

RUBBLE_TEST(ResizingTest)
#include "ResizingTest.moc"
