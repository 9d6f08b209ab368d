// Tests core/fracture/kinds/SurfaceScatter.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/fracture/SolidSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The distance to the boundary of the unit square.
double depthInSquare(Vec2 point) { return std::min({point.x, point.y, 1.0 - point.x, 1.0 - point.y}); }

std::vector<Vec2> placesIn(const SurfaceScatter& layer, const Polygon& outline) {
    return layerSeeds(layer, outline, 1).value().positions;
}

}  // namespace

class SurfaceScatterTest : public QObject {
    Q_OBJECT
private slots:
    void seedsLieBetweenTheDepths() {
        const SurfaceScatter layer{.count = 500, .minDepth = 0.02, .maxDepth = 0.1};
        for (const auto& [name, mesh] :
             {std::pair("cube", boxMeshOf({0, 0, 0}, {1, 1, 1})), std::pair("torus", torus(24, 16)),
              std::pair("U", cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}))}) {
            const SolidDomain domain = domainOf(mesh);
            const Seeds seeds = layerSeedsIn(layer, domain).value();
            QCOMPARE(seeds.ids.size(), std::size_t{500});
            for (const Vec3 seed : positionsOf(seeds)) {
                QVERIFY2(domain.depth(seed) >= 0.02 - 1e-9 && domain.depth(seed) <= 0.1 + 1e-9, name);
            }
        }
        const Seeds inPlane = layerSeeds(layer, unitSquare(), 1).value();
        QCOMPARE(inPlane.positions.size(), std::size_t{500});
        QVERIFY(inPlane.heights.empty());
        for (const Vec2 seed : inPlane.positions)
            QVERIFY(depthInSquare(seed) >= 0.02 - 1e-9 && depthInSquare(seed) <= 0.1 + 1e-9);
    }
    void densityDecreasesWithTheDepth() {
        // Linear falloff in a thin shell: three quarters of the seeds lie in the upper half.
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        const SurfaceScatter layer{.count = 4000, .maxDepth = 0.01, .falloff = 1.0};
        double upper = 0.0, inPlane = 0.0;
        for (const Vec3 seed : positionsOf(layerSeedsIn(layer, cube).value())) upper += cube.depth(seed) < 0.005;
        for (const Vec2 seed : placesIn(layer, unitSquare())) inPlane += depthInSquare(seed) < 0.005;
        QVERIFY(std::abs(upper - 3000.0) < 140.0);  // five standard deviations
        QVERIFY(std::abs(inPlane - 3000.0) < 140.0);
    }
    void facesGetSeedsByTheirArea() {
        const SolidDomain box = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 0.1}));  // 0.4 of 2.4 m² are sides
        double sides = 0.0;
        for (const Vec3 seed : positionsOf(layerSeedsIn(SurfaceScatter{.count = 4800, .maxDepth = 1e-3}, box).value()))
            sides += seed.z > 1e-3 && seed.z < 0.099;
        QVERIFY(std::abs(sides - 800.0) < 150.0);
    }
    void holesAndThinPlatesAreFollowed() {
        const Polygon shape = lShapeWithHole();
        for (const Vec2 seed : placesIn({.count = 300, .maxDepth = 0.05}, shape))
            QVERIFY(containment(shape, seed) != Containment::Outside);
        const SolidDomain plate = domainOf(transformed(boxMeshOf({0, 0, 0}, {1, 1, 1e-3}), obliqueTurn()));
        const Seeds seeds = layerSeedsIn(SurfaceScatter{.count = 300, .maxDepth = 0.1}, plate).value();
        QCOMPARE(seeds.ids.size(), std::size_t{300});
        for (const Vec3 seed : positionsOf(seeds)) QVERIFY(plate.contains(seed));
    }
    void depthBelowAllOfTheMeshIsReported() {
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        const Seeds seeds = layerSeedsIn(SurfaceScatter{.count = 10, .minDepth = 0.6, .maxDepth = 0.7}, cube).value();
        QVERIFY(seeds.ids.empty());
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].message, std::string("Layer 1 found room for 0 of 10 seeds: hardly any point is "
                                                           "0.6 m below the surface."));
    }
    void wrongDepthsAreRefused() {
        const Pattern pattern{{{.id = 4, .parameters = SurfaceScatter{.minDepth = 0.5, .maxDepth = 0.25}}}};
        QCOMPARE(verifyPattern(pattern).value_or(""),
                 std::string("Layer 4: \"Minimum depth\" is 0.5 m, but must not be above \"Maximum depth\", which is "
                             "0.25 m."));
    }
    void greaterCountKeepsEarlierSeeds() {
        const auto few = positionsByIndex(layerSeeds(SurfaceScatter{.count = 10}, unitSquare(), 1).value());
        const auto many = positionsByIndex(layerSeeds(SurfaceScatter{.count = 30}, unitSquare(), 1).value());
        for (const auto& [index, position] : few) QCOMPARE(many.at(index), position);
    }
};

RUBBLE_TEST(SurfaceScatterTest)
#include "SurfaceScatterTest.moc"
