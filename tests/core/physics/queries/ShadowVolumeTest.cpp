#include "core/physics/queries/ShadowVolume.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <cmath>

using namespace rubble;

namespace {

/// The shadow volume of a box of 2 m whose near face is at z = -4.
ShadowVolume shadowOfCube() {
    return shadowVolumeOf(test::hullOf(test::boxOf(Vec3(2.0))), Mat3(1.0), {0.0, 0.0, -5.0});
}

/// A square of 8 m at a distance in front of the viewpoint.
FacePolygon square(double distance) {
    return {{-4.0, -4.0, -distance}, {4.0, -4.0, -distance}, {4.0, 4.0, -distance}, {-4.0, 4.0, -distance}};
}

double areaOf(const std::vector<FacePolygon>& parts) {
    double area = 0.0;
    for (const FacePolygon& part : parts) {
        Vec3 twice(0.0);
        for (std::size_t k = 2; k < part.size(); ++k) twice += glm::cross(part[k - 1] - part[0], part[k] - part[0]);
        area += twice.z / 2.0;  // counter-clockwise from the viewpoint
    }
    return area;
}

}  // namespace

class ShadowVolumeTest : public QObject {
    Q_OBJECT
private slots:
    void cubeTurnsOneFaceToTheViewpoint() {
        const ShadowVolume volume = shadowOfCube();
        QCOMPARE(volume.faces.size(), 1u);
        QCOMPARE(volume.planes.size(), 5u);  // that face's, and four of its edges
        QVERIFY(std::abs(areaOf(volume.faces) - 4.0) < 1e-9);
    }
    void pointsBehindTheHullAreHidden() {
        const ShadowVolume volume = shadowOfCube();
        QVERIFY(isHidden(volume, {0.0, 0.0, -7.0}));
        QVERIFY(isHidden(volume, {1.9, 0.0, -8.0}));
        QVERIFY(!isHidden(volume, {2.1, 0.0, -8.0}));
        QVERIFY(!isHidden(volume, {0.0, 0.0, -3.9}));
        QVERIFY(!isHidden(volume, {0.0, 0.0, 8.0}));
    }
    void shadowGrowsWithTheDistance() {
        std::vector<FacePolygon> visible;
        QVERIFY(subtractShadow(square(8.0), shadowOfCube(), visible));
        QVERIFY(std::abs(areaOf(visible) - (64.0 - 16.0)) < 1e-6);  // the near face's 2 m, twice as far
    }
    void facesBesideTheShadowStayWhole() {
        std::vector<FacePolygon> visible;
        FacePolygon beside = square(8.0);
        for (Vec3& corner : beside) corner.x += 6.1;
        QVERIFY(!subtractShadow(beside, shadowOfCube(), visible));
        QVERIFY(!subtractShadow(square(4.0), shadowOfCube(), visible));  // level with the near face
        QVERIFY(!subtractShadow(square(3.0), shadowOfCube(), visible));
        QVERIFY(visible.empty());
    }
    void faceThatTouchesFromBehindIsHidden() {
        std::vector<FacePolygon> visible;
        FacePolygon behind = square(6.0);
        for (Vec3& corner : behind) corner = {corner.x / 4.0, corner.y / 4.0, corner.z};
        QVERIFY(subtractShadow(behind, shadowOfCube(), visible));
        QVERIFY(visible.empty() && isHidden(shadowOfCube(), behind) && !isHidden(shadowOfCube(), square(8.0)));
        FacePolygon side{{1.0, -1.0, -4.0}, {1.0, -1.0, -6.0}, {1.0, 1.0, -6.0}, {1.0, 1.0, -4.0}};
        QVERIFY(subtractShadow(side, shadowOfCube(), visible));
        QVERIFY(visible.empty());
    }
    /// A square cut in the middle, one that touches the plane from either side with an edge, and one in the plane.
    void polygonIsSplitIntoWhatReachesThere() {
        const FacePolygon whole{{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}};
        const auto sizes = [&](Vec3 normal, double offset) {
            const SplitPolygon parts = split(whole, {normal, offset});
            return std::pair(parts.front.size(), parts.behind.size());
        };
        QCOMPARE(sizes({1.0, 0.0, 0.0}, 0.0), std::pair(std::size_t{4}, std::size_t{4}));
        QCOMPARE(sizes({1.0, 0.0, 0.0}, -1.0), std::pair(std::size_t{4}, std::size_t{0}));
        QCOMPARE(sizes({1.0, 0.0, 0.0}, 1.0), std::pair(std::size_t{0}, std::size_t{4}));
        QCOMPARE(sizes({0.0, 0.0, 1.0}, 0.0), std::pair(std::size_t{0}, std::size_t{4}));
    }
    void hullAroundTheViewpointHidesNothing() {
        const ShadowVolume volume = shadowVolumeOf(test::hullOf(test::boxOf(Vec3(2.0))), Mat3(1.0), Vec3(0.5));
        QVERIFY(volume.faces.empty() && volume.planes.empty());
        std::vector<FacePolygon> visible;
        QVERIFY(!isHidden(volume, {0.0, 0.0, -7.0}) && !subtractShadow(square(8.0), volume, visible));
    }
    /// Against rays: random solids, and random points on a square behind them.
    void shadowIsWhereRaysEnterTheHull() {
        Random random(7);
        for (int round = 0; round < 200; ++round) {
            const Vec3 centre = test::randomIn(random, 1.0) - Vec3(0.0, 0.0, 2.0);
            const Hull hull = test::hullOf(test::randomSolid(random));
            const ShadowVolume volume = shadowVolumeOf(hull, glm::mat3_cast(test::randomRotation(random)), centre);
            if (volume.planes.empty()) continue;
            std::vector<FacePolygon> visible;
            const FacePolygon target = square(3.5);
            if (!subtractShadow(target, volume, visible)) visible.push_back(target);
            int hidden = 0;
            constexpr int kSide = 60;
            for (int k = 0; k < kSide * kSide; ++k) {
                const Vec3 point(-4.0 + 8.0 * (k % kSide + 0.5) / kSide, -4.0 + 8.0 * (k / kSide + 0.5) / kSide, -3.5);
                hidden += isHidden(volume, point) ? 1 : 0;
            }
            const double sampled = 64.0 * hidden / (kSide * kSide);
            QVERIFY2(
                std::abs(64.0 - areaOf(visible) - sampled) < 0.05 + 0.1 * sampled,
                qPrintable(QString("round %1: %2, sampled %3").arg(round).arg(64.0 - areaOf(visible)).arg(sampled)));
        }
    }
};

RUBBLE_TEST(ShadowVolumeTest)
#include "ShadowVolumeTest.moc"
