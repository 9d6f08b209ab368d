// Tests core/fracture/pattern/Pattern.cpp in space, with core/fracture/sampling/SolidScatterDomain.h.
#include "core/fracture/pattern/PatternKind.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/fracture/SolidSeeds.h"

#include <QTest>

#include <limits>

using namespace rubble;
using namespace rubble::test;

class SolidPatternTest : public QObject {
    Q_OBJECT
private slots:
    void layersComeInOrderWithNamesAndHeights() {
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        const Pattern pattern{{{.id = 4, .randomSeed = 1, .parameters = UniformScatter{.count = 3}},
                               {.id = 6, .isOn = false, .parameters = UniformScatter{.count = 5}},
                               {.id = 5, .randomSeed = 2, .parameters = UniformScatter{.count = 2}}}};
        const Seeds seeds = seedsOf(pattern, cube).value();
        QCOMPARE(seeds.ids, (std::vector<SeedId>{{4, 0}, {4, 1}, {4, 2}, {5, 0}, {5, 1}}));
        QCOMPARE(seeds.heights.size(), std::size_t{5});
        QCOMPARE(seeds.at(1), Vec3(seeds.positions[1], seeds.heights[1]));
        for (const Vec3 seed : positionsOf(seeds)) QVERIFY(cube.contains(seed));
    }
    void overridesMoveAndDeleteSeeds() {
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        Pattern pattern{{{.id = 4, .randomSeed = 1, .parameters = UniformScatter{.count = 4}}}};
        const Seeds before = seedsOf(pattern, cube).value();
        pattern.layers[0].overrides = {{.index = 1, .position = {0.25, 0.5}, .height = 0.75},
                                       {.index = 2, .isDeleted = true},
                                       {.index = 9, .position = {0.5, 0.5}}};
        const Seeds after = seedsOf(pattern, cube).value();
        QCOMPARE(after.ids, (std::vector<SeedId>{{4, 0}, {4, 1}, {4, 3}}));
        QCOMPARE(positionsOf(after), (std::vector<Vec3>{before.at(0), {0.25, 0.5, 0.75}, before.at(3)}));
        QCOMPARE(after.diagnostics.size(), std::size_t{1});
        QCOMPARE(after.diagnostics[0].message,
                 std::string("Layer 4 has no seed 9 any more; its manual change is ignored."));
    }
    void heightThatIsNotFiniteIsRefused() {
        Pattern pattern{{{.id = 4, .parameters = UniformScatter{}}}};
        pattern.layers[0].overrides = {{.index = 1, .height = std::numeric_limits<double>::infinity()}};
        QCOMPARE(verifyPattern(pattern).value_or(""),
                 std::string("Layer 4: the change to seed 1 moves it to a height of inf, which is not finite."));
    }
    void kindsThatNeedAPlaneSaySo() {
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        const Pattern pattern{
            {{.id = 3, .parameters = UniformScatter{.count = 2}}, {.id = 4, .parameters = CrackLines{}}}};
        const Seeds seeds = seedsOf(pattern, cube).value();
        QCOMPARE(seeds.positions.size(), std::size_t{2});
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::NeedsPlane);
        QCOMPARE(seeds.diagnostics[0].place.layer, 4u);
        QCOMPARE(seeds.diagnostics[0].message,
                 std::string("Layer 4 (Crack lines) needs a plane and has no effect on a mesh."));
    }
    void densityAndFragmentSizeAreTakenOfTheVolume() {
        const SolidDomain box = domainOf(boxMeshOf({0, 0, 0}, {1, 2, 3}));
        QCOMPARE(layerSeedsIn(UniformScatter{.count = {CountBy::Density, 8.0}}, box)->ids.size(), std::size_t{48});
        QCOMPARE(layerSeedsIn(UniformScatter{.count = {CountBy::FragmentSize, 0.5}}, box)->ids.size(), std::size_t{48});
        const LayerParameter& count = kindOf(UniformScatter{}).parameters[0];
        QCOMPARE(parameterText(count, SeedCount(CountBy::Density, 8.0), SeedSpace::Solid),
                 std::string("8 per cubic metre"));
    }
    void boundingBoxIsFilled() {
        const SolidDomain shape = domainOf(cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        const Seeds seeds =
            layerSeedsIn(UniformScatter{.count = 4000, .domain = ScatterDomain::BoundingBox}, shape).value();
        int missingQuarter = 0;
        for (const Vec3 seed : positionsOf(seeds)) missingQuarter += !shape.contains(seed);
        QVERIFY(std::abs(missingQuarter - 1000) < 140);  // five standard deviations
    }
    void growthKeepsSeedsOfUniformLayers() {
        const SolidDomain domain = domainOf(torus(20, 12));
        const std::vector<Vec3> few = positionsOf(layerSeedsIn(UniformScatter{.count = 20}, domain).value());
        std::vector<Vec3> many = positionsOf(layerSeedsIn(UniformScatter{.count = 50}, domain).value());
        many.resize(20);
        QCOMPARE(many, few);
    }
};

RUBBLE_TEST(SolidPatternTest)
#include "SolidPatternTest.moc"
