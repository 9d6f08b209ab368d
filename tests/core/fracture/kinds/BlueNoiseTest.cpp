// Tests core/fracture/kinds/BlueNoise.cpp, core/fracture/sampling/SeedGrid.cpp and
// core/fracture/sampling/VoidCells.cpp.
#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

Result<Seeds> triedBlueNoise(const BlueNoise& noise, const Polygon& outline) { return layerSeeds(noise, outline, 3); }

Seeds blueNoiseSeeds(const BlueNoise& noise, const Polygon& outline) { return triedBlueNoise(noise, outline).value(); }

double leastSquaredDistance(const std::vector<Vec2>& points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, squaredLength(points[i] - points[j]));
    }
    return least;
}

double squaredDistanceToNearest(Vec2 place, const std::vector<Vec2>& points) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 point : points) least = std::min(least, squaredLength(place - point));
    return least;
}

}  // namespace

class BlueNoiseTest : public QObject {
    Q_OBJECT
private slots:
    void seedsKeepTheMinimumDistance() {
        for (const Polygon& outline : {unitSquare(), lShapeWithHole()}) {
            const Seeds seeds = blueNoiseSeeds({.minimumDistance = 0.05}, outline);
            QVERIFY(leastSquaredDistance(seeds.positions) >= 0.05 * 0.05);
            for (const Vec2 seed : seeds.positions) QVERIFY(containment(outline, seed) != Containment::Outside);
        }
    }
    void maximalSamplingLeavesNoGap() {
        // Every point of a fine grid in the outline is nearer to a seed than the distance, up to 1/1000.
        const double distance = 0.1;
        const Polygon outline = lShapeWithHole();
        const Seeds seeds = blueNoiseSeeds({.minimumDistance = distance}, outline);
        for (double x = 0.0; x <= 2.0; x += 0.0101) {
            for (double y = 0.0; y <= 2.0; y += 0.0101) {
                if (containment(outline, {x, y}) == Containment::Outside) continue;
                QVERIFY(squaredDistanceToNearest({x, y}, seeds.positions) <= 1.01 * 1.01 * distance * distance);
            }
        }
    }
    void maximalCountIsWithinPackingBounds() {
        // Discs of radius d cover the square: at least 1 / (pi d^2) = 318.8. Discs of radius d / 2 do not overlap and
        // fill at most pi / sqrt(12) of the square grown by d / 2: at most 2 (1 + d)^2 / (sqrt(3) d^2) = 1230.6.
        const std::size_t count = blueNoiseSeeds({.minimumDistance = 0.0316}, unitSquare()).positions.size();
        QVERIFY2(count >= 319 && count <= 1230, qPrintable(QString::number(count)));
    }
    void greaterCountKeepsEarlierSeeds() {
        const Seeds full = blueNoiseSeeds({.minimumDistance = 0.1}, lShapeWithHole());
        for (const std::uint32_t count : {1u, 10u, 100u}) {
            const Seeds few = blueNoiseSeeds({.minimumDistance = 0.1, .count = count}, lShapeWithHole());
            QCOMPARE(few.positions.size(), std::size_t{count});
            QVERIFY(std::equal(few.positions.begin(), few.positions.end(), full.positions.begin()));
            QVERIFY(few.diagnostics.empty());
        }
    }
    void missingRoomIsReported() {
        // No two points of a unit square are 1.5 m apart: its diagonal is 1.41 m.
        const Seeds seeds = blueNoiseSeeds({.minimumDistance = 1.5, .count = 7}, unitSquare());
        QCOMPARE(seeds.positions.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::NoRoom);
        QCOMPARE(seeds.diagnostics[0].place.layer, 1u);
        QCOMPARE(seeds.diagnostics[0].value, 1.0);
        QCOMPARE(seeds.diagnostics[0].message,
                 std::string("Layer 1 found room for 1 of 7 seeds at a distance of 1.5 m."));
    }
    void boundingBoxIsFilled() {
        const Seeds seeds =
            blueNoiseSeeds({.minimumDistance = 0.1, .domain = ScatterDomain::BoundingBox}, lShapeWithHole());
        int missingQuarter = 0;
        for (const Vec2 seed : seeds.positions) missingQuarter += seed.x > 1.0 && seed.y > 1.0 ? 1 : 0;
        QVERIFY(missingQuarter > 40);
    }
    void sliversTakeBoundedTime() {
        const Polygon sliver{{{0.0, 0.0}, {1.0, 1.0}, {0.999999, 1.0}}, {}};
        const Seeds seeds = blueNoiseSeeds({.minimumDistance = 0.01}, sliver);
        QVERIFY(seeds.positions.size() > 70 && seeds.positions.size() < 143);  // sqrt(2) / 0.01 at most, half at least
    }
    void tinyDistancesTerminate() {
        const Seeds seeds = blueNoiseSeeds({.minimumDistance = 1e-200, .count = 1000}, unitSquare());
        QCOMPARE(seeds.positions.size(), std::size_t{1000});
        // 1e-9 m at 1e6 m is ten units in the last place: only a hundred points exist.
        Polygon speck = unitSquare();
        for (Vec2& corner : speck.outer) corner = corner * 1e-9 + Vec2{1e6, 1e6};
        QVERIFY(triedBlueNoise({.minimumDistance = 1e-100, .count = 1000}, speck).hasValue());
    }
    void invalidDistancesAreRejected() {
        const double infinity = std::numeric_limits<double>::infinity();
        for (const double distance : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
            const Result<Seeds> seeds = triedBlueNoise({.minimumDistance = distance}, unitSquare());
            QVERIFY(!seeds);
            QCOMPARE(seeds.error().code, ErrorCode::BadInput);
        }
        QCOMPARE(triedBlueNoise({.minimumDistance = -1.0}, unitSquare()).error().message,
                 std::string("Layer 1: \"Distance\" is -1 m, but must be finite and above zero."));
    }
    void tooManySeedsAreRejectedEarly() {
        const Result<Seeds> seeds = triedBlueNoise({.minimumDistance = 1e-5}, unitSquare());
        QVERIFY(!seeds);
        QCOMPARE(seeds.error().code, ErrorCode::Limit);
    }
};

RUBBLE_TEST(BlueNoiseTest)
#include "BlueNoiseTest.moc"
