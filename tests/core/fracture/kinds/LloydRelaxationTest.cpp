// Tests core/fracture/kinds/LloydRelaxation.cpp and core/fracture/kinds/Relaxation.cpp.
#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

const Polygon kBar{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {0.0, 1.0}}, {}};

Seeds relaxed(Pattern pattern, std::uint32_t rounds) {
    pattern.layers.push_back({.id = 9, .parameters = LloydRelaxation{rounds}});
    return seedsOf(pattern, kBar).value();
}

}  // namespace

class LloydRelaxationTest : public QObject {
    Q_OBJECT
private slots:
    void scatteredSeedsMoveToCentroids() {
        // The cell of a single seed is the whole bar.
        const Seeds seeds = relaxed({{{.id = 1, .parameters = UniformScatter{.count = 1}}}}, 1);
        QCOMPARE(seeds.positions.size(), std::size_t{1});
        QVERIFY(glm::length(seeds.positions[0] - Vec2(2.0, 0.5)) < 1e-12);
        QCOMPARE(seeds.ids[0], (SeedId{1, 0}));
    }
    void placedSeedsStay() {
        // The placed seed at x = 1 keeps the left part; one round moves the other to the middle of the rest.
        Pattern pattern{{{.id = 1, .parameters = PlacedSeeds{{{0, {1.0, 0.5}}}}},
                         {.id = 2, .parameters = UniformScatter{.count = 1}}}};
        pattern.layers[1].overrides = {};
        const Seeds seeds = relaxed(pattern, 200);
        QCOMPARE(seeds.positions[0], Vec2(1.0, 0.5));
        // In equilibrium x is the middle of [(1 + x) / 2, 4]: x = 3.
        QVERIFY(glm::length(seeds.positions[1] - Vec2(3.0, 0.5)) < 1e-9);
    }
    void seedsMovedByHandStay() {
        Pattern pattern{{{.id = 1, .parameters = UniformScatter{.count = 2}}}};
        pattern.layers[0].overrides = {{.index = 0, .position = {0.25, 0.75}}};
        const Seeds seeds = relaxed(pattern, 3);
        QCOMPARE(seeds.positions[0], Vec2(0.25, 0.75));
    }
    void zeroRoundsChangeNothing() {
        const Pattern pattern{{{.id = 1, .parameters = UniformScatter{.count = 5}}}};
        QCOMPARE(relaxed(pattern, 0).positions, seedsOf(pattern, kBar)->positions);
    }
    void laterLayersAreNotMoved() {
        const Pattern pattern{
            {{.id = 1, .parameters = LloydRelaxation{2}}, {.id = 2, .parameters = UniformScatter{.count = 3}}}};
        QCOMPARE(seedsOf(pattern, kBar)->positions, seedsOf({{pattern.layers[1]}}, kBar)->positions);
    }
    void tooManyRoundsAreRejected() {
        const Result<Seeds> seeds = seedsOf({{{.id = 3, .parameters = LloydRelaxation{4000}}}}, kBar);
        QVERIFY(!seeds);
        QCOMPARE(seeds.error().message, std::string("Layer 3: \"Rounds\" is 4000, but must be from 0 to 1000."));
    }
};

RUBBLE_TEST(LloydRelaxationTest)
#include "LloydRelaxationTest.moc"
