#include "core/geometry/polygon/NarrowFeatures.h"

#include "core/base/Random.h"
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
