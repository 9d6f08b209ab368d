#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

Pattern placed(std::vector<PlacedSeeds::Seed> seeds) {
    return {{{.id = 4, .parameters = PlacedSeeds{std::move(seeds)}}}};
}

std::string patternFault(const Pattern& pattern) {
    const Result<Seeds> seeds = seedsOf(pattern, unitSquare());
    if (seeds) return "no fault";
    return seeds.error().code == ErrorCode::BadInput ? seeds.error().message : "another code";
}

}  // namespace

class PatternTest : public QObject {
    Q_OBJECT
private slots:
    void emptyPatternGivesNoSeeds() {
        const Result<Seeds> seeds = seedsOf({}, unitSquare());
        QVERIFY(seeds && seeds->positions.empty() && seeds->ids.empty() && seeds->diagnostics.empty());
    }
    void layersAddInOrderAndDisabledOnesAreSkipped() {
        Pattern pattern{{{.id = 1, .parameters = UniformScatter{.count = 2}},
                         {.id = 2, .isOn = false, .parameters = UniformScatter{.count = 9}},
                         {.id = 3, .parameters = PlacedSeeds{{{.index = 7, .position = {0.5, 0.25}}}}}}};
        const Result<Seeds> seeds = seedsOf(pattern, unitSquare());
        QVERIFY(seeds.hasValue());
        QCOMPARE(seeds->ids, (std::vector<SeedId>{{1, 0}, {1, 1}, {3, 7}}));
        QCOMPARE(seeds->positions[2], Vec2(0.5, 0.25));
        QCOMPARE(seeds->ids[2].text(), std::string("3.7"));
    }
    void layersWithEqualRandomSeedsDiffer() {
        const Pattern pattern{{{.id = 1, .randomSeed = 5, .parameters = UniformScatter{.count = 1}},
                               {.id = 2, .randomSeed = 5, .parameters = UniformScatter{.count = 1}}}};
        const Result<Seeds> seeds = seedsOf(pattern, unitSquare());
        QVERIFY(seeds->positions[0] != seeds->positions[1]);
    }
    void overridesMoveAndDeleteSingleSeeds() {
        Pattern pattern{{{.id = 1, .parameters = UniformScatter{.count = 4}}}};
        const Seeds before = *seedsOf(pattern, unitSquare());
        pattern.layers[0].overrides = {{.index = 1, .position = {0.125, 2.0}}, {.index = 2, .isDeleted = true}};
        const Seeds after = *seedsOf(pattern, unitSquare());
        QCOMPARE(after.ids, (std::vector<SeedId>{{1, 0}, {1, 1}, {1, 3}}));
        QCOMPARE(after.positions, (std::vector<Vec2>{before.positions[0], {0.125, 2.0}, before.positions[3]}));
        QVERIFY(after.diagnostics.empty());
    }
    void overridesOfMissingSeedsAreReported() {
        Pattern pattern{{{.id = 6, .parameters = UniformScatter{.count = 2}}}};
        pattern.layers[0].overrides = {{.index = 1, .isDeleted = true}, {.index = 5}};
        const Seeds seeds = *seedsOf(pattern, unitSquare());
        QCOMPARE(seeds.positions.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::LostOverride);
        QCOMPARE(seeds.diagnostics[0].place.index, 5u);
        QCOMPARE(seeds.diagnostics[0].place.layer, 6u);
        QCOMPARE(seeds.diagnostics[0].message,
                 std::string("Layer 6 has no seed 5 any more; its manual change is ignored."));
    }
    void placedSeedsKeepTheirIndices() {
        const Seeds seeds = *seedsOf(placed({{2, {0.5, 0.5}}, {9, {3.0, 3.0}}}), unitSquare());
        QCOMPARE(seeds.ids, (std::vector<SeedId>{{4, 2}, {4, 9}}));
        QCOMPARE(seeds.positions[1], Vec2(3.0, 3.0));
    }
    void invalidParametersAreRejectedWithTheirLayer() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(patternFault(placed({{2, {0.5, nan}}})),
                 std::string("Layer 4: seed 2 is at (0.5, nan), which is not finite."));
        QCOMPARE(patternFault(placed({{2, {0.0, 0.0}}, {2, {0.5, 0.5}}})),
                 std::string("Layer 4: seed 2 does not come after seed 2."));
        Pattern pattern{{{.id = 4, .parameters = UniformScatter{}, .overrides = {{.index = 3}, {.index = 1}}}}};
        QCOMPARE(patternFault(pattern),
                 std::string("Layer 4: the change to seed 1 does not come after the one to seed 3."));
        pattern.layers[0].overrides = {{.index = 3, .position = {nan, 1.0}}};
        QCOMPARE(patternFault(pattern),
                 std::string("Layer 4: the change to seed 3 moves it to (nan, 1), which is not finite."));
        pattern.layers[0].isOn = false;  // disabled layers are verified, too: they are saved with the rest
        QVERIFY(patternFault(pattern) != "no fault");
    }
    void tooManySeedsAreRejected() {
        const Pattern pattern{{{.id = 1, .parameters = UniformScatter{.count = 1}},
                               {.id = 2, .parameters = UniformScatter{.count = kMaxSeeds}}}};
        const Result<Seeds> seeds = seedsOf(pattern, unitSquare());
        QVERIFY(!seeds);
        QCOMPARE(seeds.error().code, ErrorCode::Limit);
        QCOMPARE(seeds.error().message, std::string("Layer 2 brings the pattern above 10000000 seeds."));
    }
    void cancelledTasksStop() {
        TaskContext task;
        task.cancel.cancel();
        const Pattern pattern{{{.id = 1, .parameters = UniformScatter{}}}};
        const Result<Seeds> seeds = seedsOf(pattern, unitSquare(), task);
        QVERIFY(!seeds);
        QCOMPARE(seeds.error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(PatternTest)
#include "PatternTest.moc"
