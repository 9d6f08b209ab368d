// Tests degenerate inputs on core/fracture/pattern/PatternPartition.cpp and all stages below it.
#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace rubble;

namespace {

using SeedPoints = std::vector<Vec2>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

double nextUp(double value) { return std::nextafter(value, kInfinity); }

/// columns × rows points, the first at the centre of a rectangle of one step.
SeedPoints grid(int columns, int rows, Vec2 corner, double step) {
    SeedPoints seeds;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) seeds.push_back(corner + step * Vec2{column + 0.5, row + 0.5});
    }
    return seeds;
}

SeedPoints scatteredPoints(std::size_t count, Vec2 min, Vec2 max, std::uint64_t randomSeed) {
    Random random(randomSeed);
    SeedPoints seeds(count);
    for (Vec2& seed : seeds) seed = {random.between(min.x, max.x), random.between(min.y, max.y)};
    return seeds;
}

/// A star with 500 tips and alternating radii 1 and 2.
Polygon thousandCorners() {
    Polygon star;
    for (int i = 0; i < 1000; ++i) {
        const double angle = i * (2.0 * std::numbers::pi / 1000.0);
        star.outer.push_back((i % 2 == 0 ? 2.0 : 1.0) * Vec2{cosine(angle), sine(angle)});
    }
    return star;
}

std::vector<DiagnosticCode> codesOf(const Partition& partition) {
    std::vector<DiagnosticCode> codes;
    for (const Diagnostic& report : partition.diagnostics) codes.push_back(report.code);
    return codes;
}

}  // namespace

/// Inputs on which fracture libraries are known to fail.
class HardCasesTest : public QObject {
    Q_OBJECT
private slots:
    void noSeedsGiveTheWholeOutline() {
        const Result<Partition> partition = verifiedPartition(lShape(), SeedPoints{});
        QCOMPARE(partition->pieceCount(), 1u);
        QCOMPARE(pieceArea(*partition, 0), 3.0);
    }
    void oneSeedGetsTheWholeOutline() {
        for (const Vec2 seed : {Vec2{0.5, 0.5}, Vec2{0.0, 0.0}, Vec2{40.0, -3.0}}) {
            const Result<Partition> partition = verifiedPartition(squareRing(), SeedPoints{seed});
            QCOMPARE(partition->pieceCount(), 1u);
            QCOMPARE(areaOfSeed(*partition, 0), 12.0);
        }
    }
    void twoSeedsHalveTheSquare() {
        const Result<Partition> partition = verifiedPartition(unitSquare(), SeedPoints{{0.25, 0.5}, {0.75, 0.5}});
        QCOMPARE(areaOfSeed(*partition, 0), 0.5);
        QCOMPARE(areaOfSeed(*partition, 1), 0.5);
    }
    void collinearSeedsGiveStrips() {
        for (const Vec2 step : {Vec2{0.125, 0.0}, Vec2{0.0, 0.125}}) {
            SeedPoints seeds;
            for (int i = 0; i < 8; ++i) seeds.push_back(Vec2{0.0625, 0.0625} + static_cast<double>(i) * step);
            const Result<Partition> partition = verifiedPartition(unitSquare(), seeds);
            for (std::uint32_t seed = 0; seed < 8; ++seed) QCOMPARE(areaOfSeed(*partition, seed), 0.125);
        }
    }
    void collinearSeedsOnADiagonalGiveSlantedStrips() {
        const Result<Partition> partition =
            verifiedPartition(unitSquare(), SeedPoints{{0.25, 0.25}, {0.5, 0.5}, {0.75, 0.75}});
        QCOMPARE(areaOfSeed(*partition, 0), 9.0 / 32.0);
        QCOMPARE(areaOfSeed(*partition, 1), 14.0 / 32.0);
        QCOMPARE(areaOfSeed(*partition, 2), 9.0 / 32.0);
    }
    void exactGridGivesSquaresWithFourNeighbours() {
        const Polygon plate{rectangle({0.0, 0.0}, {100.0, 100.0}), {}};
        const Result<Partition> partition = verifiedPartition(plate, grid(100, 100, {0.0, 0.0}, 1.0));
        QVERIFY2(partition.hasValue(), partition ? "" : partition.error().message.c_str());
        QCOMPARE(partition->pieceCount(), 10'000u);
        std::size_t contacts = 0;
        for (std::uint32_t piece = 0; piece < partition->pieceCount(); ++piece) {
            QCOMPARE(pieceArea(*partition, piece), 1.0);
            contacts += contactsOf(*partition, piece, kMinSharedEdge * 142.0).size();
        }
        QCOMPARE(contacts, std::size_t{2 * (100 * 99 + 99 * 100)});
    }
    void roundedGridVerifies() {
        QCOMPARE(partitionFault(unitSquare(), grid(100, 100, {0.0, 0.0}, 0.01)), std::string());
    }
    void ofEqualSeedsTheFirstIsKept() {
        const SeedPoints seeds = {{0.75, 0.5}, {0.25, 0.5}, {0.75, 0.5}, {0.25, 0.5}, {0.75, 0.5}};
        const Result<Partition> partition = verifiedPartition(unitSquare(), seeds);
        QCOMPARE(areaOfSeed(*partition, 0), 0.5);
        QCOMPARE(areaOfSeed(*partition, 1), 0.5);
        QCOMPARE(partition->diagnostics.size(), std::size_t{3});
        QCOMPARE(partition->diagnostics[0].message, std::string("Seed 2 equals seed 0 and was left out."));
        QCOMPARE(partition->diagnostics[1].message, std::string("Seed 3 equals seed 1 and was left out."));
        QCOMPARE(partition->diagnostics[2].message, std::string("Seed 4 equals seed 0 and was left out."));
    }
    void equalSeedsAreOneSeed() {
        const Result<Partition> partition = verifiedPartition(unitSquare(), SeedPoints(50, Vec2{0.5, 0.5}));
        QCOMPARE(areaOfSeed(*partition, 0), 1.0);
        QCOMPARE(partition->diagnostics.size(), std::size_t{49});
    }
    void seedsOneUlpApartAreDistinct() {
        const Result<Partition> partition = verifiedPartition(unitSquare(), SeedPoints{{0.5, 0.5}, {nextUp(0.5), 0.5}});
        QCOMPARE(areaOfSeed(*partition, 0), 0.5);
        QCOMPARE(areaOfSeed(*partition, 1), 0.5);
        QVERIFY(partition->diagnostics.empty());
    }
    void cellThinnerThanCoordinatesIsReported() {
        const double second = nextUp(0.5), third = nextUp(second);
        const Result<Partition> partition =
            verifiedPartition(unitSquare(), SeedPoints{{0.5, 0.5}, {second, 0.5}, {third, 0.5}});
        QCOMPARE(codesOf(*partition), std::vector<DiagnosticCode>{DiagnosticCode::SeedWithoutCell});
        QCOMPARE(partition->diagnostics[0].place.seed, 1u);
    }
    void clusterOfAdjacentDoublesVerifies() {
        SeedPoints seeds = scatteredPoints(20, {0.0, 0.0}, {1.0, 1.0}, 5);
        for (int i = 0; i < 16; ++i) seeds.push_back({0.5 + 0x1p-53 * (i % 4), 0.5 + 0x1p-53 * (i / 4)});
        QCOMPARE(partitionFault(unitSquare(), seeds), std::string());
    }
    void seedsOnTheOutlineHaveCells() {
        const Result<Partition> partition =
            verifiedPartition(unitSquare(), SeedPoints{{0.5, 0.0}, {1.0, 0.5}, {0.5, 1.0}, {0.0, 0.5}});
        for (std::uint32_t seed = 0; seed < 4; ++seed) QCOMPARE(areaOfSeed(*partition, seed), 0.25);
    }
    void seedsOnTheCornersHaveQuarters() {
        const Result<Partition> partition = verifiedPartition(unitSquare(), unitSquare().outer);
        for (std::uint32_t seed = 0; seed < 4; ++seed) QCOMPARE(areaOfSeed(*partition, seed), 0.25);
    }
    void seedsAtAllCornersOfAConcaveOutlineVerify() {
        const Polygon ring = squareRing();
        SeedPoints seeds = ring.outer;
        seeds.insert(seeds.end(), ring.holes[0].begin(), ring.holes[0].end());
        QCOMPARE(partitionFault(ring, seeds), std::string());
        QCOMPARE(partitionFault(lShape(), lShape().outer), std::string());
    }
    void seedsOutsideCompete() {
        const Result<Partition> partition =
            verifiedPartition(unitSquare(), SeedPoints{{0.5, 0.5}, {1.25, 0.5}, {-7.0, 0.5}, {1e20, 0.0}});
        QCOMPARE(areaOfSeed(*partition, 0), 0.875);
        QCOMPARE(areaOfSeed(*partition, 1), 0.125);
        QCOMPARE(codesOf(*partition), (std::vector{DiagnosticCode::SeedWithoutCell, DiagnosticCode::SeedWithoutCell}));
        QCOMPARE(partition->diagnostics[0].message, std::string("Seed 2 has no cell inside the outline."));
    }
    void gridIsExactFarFromTheOrigin() {
        const double step = 0x1p-20;  // 1e-6 m
        const Vec2 corner{0x1p20, -0x1p20};
        const Polygon outline{rectangle(corner, corner + 16.0 * step), {}};
        const Result<Partition> partition = verifiedPartition(outline, grid(16, 16, corner, step));
        QVERIFY2(partition.hasValue(), partition ? "" : partition.error().message.c_str());
        for (std::uint32_t seed = 0; seed < 256; ++seed) QCOMPARE(areaOfSeed(*partition, seed), step * step);
    }
    void roundedGridVerifiesFarFromTheOrigin() {
        const Vec2 corner{1e6, 1e6};
        const Polygon outline{rectangle(corner, corner + 1.6e-5), {}};
        QCOMPARE(partitionFault(outline, grid(16, 16, corner, 1e-6)), std::string());
        QCOMPARE(partitionFault(outline, scatteredPoints(200, corner, corner + 1.6e-5, 9)), std::string());
    }
    void sliversVerify() {
        const Polygon sliver{rectangle({0.0, 0.0}, {1.0, 0.001}), {}};
        for (std::uint64_t randomSeed = 0; randomSeed < 200; ++randomSeed) {
            const SeedPoints seeds = scatteredPoints(5 + randomSeed % 100, {0.0, 0.0}, {1.0, 0.001}, randomSeed);
            QCOMPARE(partitionFault(sliver, seeds), std::string());
        }
    }
    void thousandCornersVerify() {
        QCOMPARE(thousandCorners().outer.size(), std::size_t{1000});
        QCOMPARE(partitionFault(thousandCorners(), scatteredPoints(50, {-2.0, -2.0}, {2.0, 2.0}, 4)), std::string());
        QCOMPARE(partitionFault(thousandCorners(), thousandCorners().outer), std::string());
    }
    void invalidOutlinesAreRejected_data() {
        QTest::addColumn<Polygon>("outline");
        QTest::addColumn<QString>("sentence");
        const Ring square = rectangle({0.0, 0.0}, {4.0, 4.0});
        const auto holed = [&](std::vector<Ring> holes) { return Polygon{square, std::move(holes)}; };
        const auto row = [](const char* name, const Polygon& outline, const char* sentence) {
            QTest::newRow(name) << outline << QString(sentence);
        };
        row("nothing at all", {}, "The outline needs at least 3 points but has 0.");
        row("crosses itself", {{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}},
            "The outline crosses itself between points 0 and 2, at (1, 1).");
        row("touches itself", {{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {}},
            "The outline touches itself: point 3 lies on the edge from point 0 to 1, at (2, 0).");
        row("no area", {{{0, 0}, {1, 1}, {2, 2}}, {}}, "The outline encloses no area: all its points lie on one line.");
        row("hole outside", holed({rectangle({5, 5}, {6, 6})}), "Hole 0 lies outside the outline.");
        row("holes cross", holed({rectangle({1, 1}, {2, 2}), rectangle({1.5, 1.5}, {3, 3})}),
            "Hole 0 after its point 1 crosses hole 1 after its point 0, at (2, 1.5).");
        row("hole in a hole", holed({rectangle({1, 1}, {3, 3}), rectangle({1.5, 1.5}, {2, 2})}),
            "Hole 1 lies inside hole 0.");
        row("NaN", {{{0, 0}, {kNotANumber, 0}, {1, 1}}, {}},
            "Point 1 of the outline is not a finite number: (nan, 0).");
        row("infinity", {{{0, 0}, {1, 0}, {1, kInfinity}}, {}},
            "Point 2 of the outline is not a finite number: (1, inf).");
    }
    void invalidOutlinesAreRejected() {
        QFETCH(Polygon, outline);
        QFETCH(QString, sentence);
        QCOMPARE(QString::fromStdString(partitionFault(outline, {{0.5, 0.5}})), sentence);
    }
    void invalidSeedsAreRejected() {
        QCOMPARE(partitionFault(unitSquare(), {{0.5, 0.5}, {0.5, kNotANumber}}),
                 std::string("Seed 1 has a coordinate that is not finite: nan."));
        QCOMPARE(partitionFault(unitSquare(), {{-kInfinity, 0.5}}),
                 std::string("Seed 0 has a coordinate that is not finite: -inf."));
    }
};

RUBBLE_TEST(HardCasesTest)
#include "HardCasesTest.moc"
