#include "core/geometry/polygon/NarrowFeatures.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

using FeatureKind = NarrowFeature::Kind;
using Features = std::vector<NarrowFeature>;

constexpr Clearance kWide{.distance = 0.1, .sine = 0.1};

Features featuresOf(const Polygon& polygon, const Clearance& clearance = kWide) {
    return narrowFeatures(indexedCorners(polygon), clearance);
}

/// A convex ring of corners at random angles of the unit circle.
Ring randomConvexRing(Random& random) {
    std::vector<double> angles(3 + random.below(6));
    for (double& angle : angles) angle = 2.0 * std::numbers::pi * random.unit();
    std::ranges::sort(angles);
    Ring ring;
    for (const double angle : angles) ring.push_back({std::cos(angle), std::sin(angle)});
    return ring;
}

/// A ring around the origin, with corners at random distances.
Ring randomStar(Random& random) {
    const std::size_t count = 5 + random.below(40);
    Ring ring;
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.8 * random.unit()) / double(count);
        const double radius = random.between(0.2, 3.0);
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

/// All corners near edges that are not theirs.
Features cornersNearEdges(const IndexedCorners& corners, double distance) {
    Features found;
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
        for (std::uint32_t edge = 0; edge < corners.cornerCount(); ++edge) {
            if (corner == edge || corner == corners.next[edge]) continue;
            const Vec2 from = corners.points[edge], to = corners.points[corners.next[edge]];
            if (distanceToSegment(corners.points[corner], from, to) <= distance)
                found.push_back({corner, edge, FeatureKind::CornerNearEdge});
        }
    }
    return found;
}

/// The processor time for a ring of `spikes` spikes side by side, ms.
double timeOfSpikes(int spikes) {
    Ring ring;
    for (int k = 0; k < 2 * spikes; ++k) {
        const double angle = std::numbers::pi * k / spikes, radius = k % 2 == 0 ? 1.0 : 0.9;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const Polygon star{ring, {}};
    const double start = test::processorTime();
    for (int k = 0; k < 4; ++k) {
        if (!featuresOf(star, requiredClearance(star)).empty()) qFatal("The spikes are not apart.");
    }
    return test::processorTime() - start;
}

}  // namespace

class NarrowFeaturesTest : public QObject {
    Q_OBJECT
private slots:
    void clearanceIsFourWeldDistances() {
        const Clearance clearance = requiredClearance(unitSquare());
        QVERIFY(clearance.distance == 0x1p-44);  // four times 2^-46 of the extent, 1 m
        QCOMPARE(clearance.sine, 0x1p-44 / (1e-9 * std::sqrt(2.0)));
    }
    void wideShapesHaveNone() {
        QVERIFY(featuresOf(unitSquare()).empty());
        QVERIFY(featuresOf(lShapeWithHole()).empty());
        QVERIFY(hasAmpleClearance(unitSquare().outer, kWide));
    }
    void shortEdgeIsFound() {
        QCOMPARE(featuresOf({{{0, 0}, {2, 0}, {2, 1}, {1.95, 1}, {0, 1}}, {}}),
                 (Features{{2, 3, FeatureKind::ShortEdge}}));
    }
    void sharpCornerIsFound() {
        QCOMPARE(featuresOf({{{0, 0}, {10, 0}, {10, 0.5}}, {}}), (Features{{0, 0, FeatureKind::SharpCorner}}));
        QVERIFY(featuresOf({{{0, 0}, {10, 0}, {10, 2}}, {}}).empty());  // a sine of 0.2
    }
    void cornerOfAHoleNearTheOuterRingIsFound() {
        const Polygon square{rectangle({0, 0}, {4, 4}), {{{0.05, 2}, {1, 3}, {1, 1}}}};
        QCOMPARE(featuresOf(square), (Features{{4, 3, FeatureKind::CornerNearEdge}}));
        QVERIFY(featuresOf(square, {.distance = 0.04, .sine = 0.04}).empty());
    }
    void cornersNearEdgesAreThoseOfAllPairs() {
        Random random(20261129);
        int found = 0, none = 0;
        for (int round = 0; round < 3000; ++round) {
            const IndexedCorners corners = indexedCorners({randomStar(random), {}});
            const Clearance clearance{.distance = round % 2 == 0 ? 0.15 : 0.005, .sine = 0.0};
            const Features features = narrowFeatures(corners, clearance);
            if (std::ranges::count(features, FeatureKind::ShortEdge, &NarrowFeature::kind) > 0) continue;
            const Features expected = cornersNearEdges(corners, clearance.distance);
            QVERIFY2(features == expected, qPrintable(QString("round %1").arg(round)));
            ++(expected.empty() ? none : found);
        }
        QVERIFY2(found > 30 && none > 300, qPrintable(QString("%1, %2").arg(found).arg(none)));
    }
    /// Linear: 4. The bounding boxes of spikes that run side by side overlap: by pairs of these, 16.
    void spikesTakeNearlyLinearTime() {
        const double small = timeOfSpikes(4000), large = timeOfSpikes(16'000);
        QVERIFY2(large < 9.0 * small, qPrintable(QString("%1 ms, %2 ms").arg(small).arg(large)));
    }
    void ringsWithAmpleClearanceHaveNoNarrowFeature() {
        int ample = 0, narrow = 0;
        for (std::uint64_t number = 1; number <= 2000; ++number) {
            Random random(number);
            const Ring ring = randomConvexRing(random);
            const double size = std::pow(10.0, random.between(-4.0, -1.0));
            const Clearance clearance{.distance = size, .sine = size};
            const Features features = featuresOf({ring, {}}, clearance);
            const bool isAmple = hasAmpleClearance(ring, clearance);
            QVERIFY2(!isAmple || features.empty(), qPrintable(QString("random seed %1").arg(number)));
            ample += isAmple ? 1 : 0;
            narrow += features.empty() ? 0 : 1;
        }
        QVERIFY2(ample > 200 && narrow > 100, qPrintable(QString("%1, %2").arg(ample).arg(narrow)));
    }
};

RUBBLE_TEST(NarrowFeaturesTest)
#include "NarrowFeaturesTest.moc"
