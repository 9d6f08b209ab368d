#include "core/base/Random.h"
#include "core/geometry/hull/HullOverlap.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

/// A unit cube centred at the origin.
Polytope centredCube() { return extruded(Ring{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, -0.5, 0.5); }

HullOverlap cubesApart(Vec3 between) { return hullOverlap(centredCube(), translated(centredCube(), between)); }

bool isNear(const HullOverlap& overlap, double depth, Vec3 normal) {
    return std::abs(overlap.depth - depth) < 1e-14 && glm::distance(overlap.normal, normal) < 1e-14;
}

Quat rotation(double angle, Vec3 axis) { return glm::angleAxis(angle, axis); }

}  // namespace

class HullOverlapTest : public QObject {
    Q_OBJECT
private slots:
    void touchingCubesHaveNoDepth() { QVERIFY(isNear(cubesApart({1.0, 0.25, 0.0}), 0.0, {1, 0, 0})); }
    void overlapOfATenth() {
        QVERIFY(isNear(cubesApart({0.9, 0.0, 0.0}), 0.1, {1, 0, 0}));
        QVERIFY(isNear(cubesApart({0.2, -0.9, 0.1}), 0.1, {0, -1, 0}));
        QVERIFY(isNear(cubesApart({0.5, 0.5, 0.7}), 0.3, {0, 0, 1}));
    }
    void gapIsNegativeDepth() { QVERIFY(isNear(cubesApart({0.0, 0.0, -3.0}), -2.0, {0, 0, -1})); }
    void containedCubeLeavesByTheNearestFace() {
        const Polytope big = extruded(Ring{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -2.0, 2.0);
        QVERIFY(isNear(hullOverlap(big, translated(centredCube(), {1.0, 0.0, 0.0})), 1.5, {1, 0, 0}));
    }
    void swappingNegatesTheNormal() {
        const Polytope other = translated(centredCube(), {0.9, 0.0, 0.0});
        QVERIFY(isNear(hullOverlap(other, centredCube()), 0.1, {-1, 0, 0}));
    }
    void edgeOnEdgeUsesTheCrossProduct() {
        // Both cubes stand on an edge, along x and along y: half a diagonal each, so they touch at a distance of √2.
        const double quarter = std::numbers::pi / 4.0;
        const Pose below{{0.0, 0.0, 0.0}, rotation(quarter, {1, 0, 0})};
        const Pose touching{{0.0, 0.0, std::numbers::sqrt2}, rotation(quarter, {0, 1, 0})};
        QVERIFY(isNear(hullOverlap(centredCube(), below, centredCube(), touching), 0.0, {0, 0, 1}));
        const Pose deep{{0.0, 0.0, std::numbers::sqrt2 - 0.1}, rotation(quarter, {0, 1, 0})};
        QVERIFY(isNear(hullOverlap(centredCube(), below, centredCube(), deep), 0.1, {0, 0, 1}));
    }
    void posesAreApplied() {
        // A rotation by 90 degrees about z moves the longer side from x to y.
        const Polytope plank = extruded(Ring{{-2, -0.5}, {2, -0.5}, {2, 0.5}, {-2, 0.5}}, -0.5, 0.5);
        const Pose upright{{0.0, 2.4, 0.0}, rotation(std::numbers::pi / 2.0, {0, 0, 1})};
        QVERIFY(isNear(hullOverlap(centredCube(), Pose{}, plank, upright), 0.1, {0, 1, 0}));
    }
    void depthIsAccurateFarFromTheOrigin() {
        const Vec3 far{1e6, -1e6, 1e6};
        const Polytope a = translated(centredCube(), far);
        const Polytope b = translated(centredCube(), far + Vec3(0.75, 0.0, 0.0));
        QVERIFY(isNear(hullOverlap(a, b), 0.25, {1, 0, 0}));
        const HullOverlap posed = hullOverlap(centredCube(), {far, rotation(0, {0, 0, 1})}, centredCube(),
                                              {far + Vec3(0.75, 0.0, 0.0), rotation(0, {0, 0, 1})});
        QVERIFY(isNear(posed, 0.25, {1, 0, 0}));
    }
    void separatingByTheDepthMakesThemTouch() {
        const std::uint64_t seed = 9;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        const auto between = [&](double low, double high) { return random.between(low, high); };
        for (int round = 0; round < 200; ++round) {
            const Vec3 axis = glm::normalize(Vec3(between(-1, 1), between(-1, 1), between(0.1, 1)));
            const Pose first{{0, 0, 0}, rotation(between(0, 3), axis)};
            Pose second{{between(-1, 1), between(-1, 1), between(-1, 1)}, rotation(between(0, 3), {0, 0, 1})};
            const HullOverlap overlap = hullOverlap(centredCube(), first, centredCube(), second);
            if (overlap.depth < 0.0) continue;
            second.position += overlap.depth * overlap.normal;
            QVERIFY(std::abs(hullOverlap(centredCube(), first, centredCube(), second).depth) < 1e-14);
            second.position += 0.5 * overlap.normal;
            QVERIFY(hullOverlap(centredCube(), first, centredCube(), second).depth <= -0.5 + 1e-14);
        }
    }
    void distanceAlongEndsAtContact() {
        const Pose above{.position = {0.2, 5.0, 0.3}};
        const auto fall = distanceAlong({0, -1, 0}, centredCube(), above, centredCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall - 4.0) < 1e-14);
        QVERIFY(!distanceAlong({0, 1, 0}, centredCube(), above, centredCube(), {}, 1e-4));
    }
    /// The downward corner is half the cube's diagonal below the centre.
    void rotatedCubeTouchesWithItsCorner() {
        const Pose tilted{{0.0, 5.0, 0.0}, rotation(std::numbers::pi / 4.0, {0, 0, 1})};
        const auto fall = distanceAlong({0, -1, 0}, centredCube(), tilted, centredCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall - (4.5 - std::sqrt(0.5))) < 1e-14);
    }
    void overlapGivesNegativeDistance() {
        const Pose sunk{.position = {0.0, 0.9, 0.0}};
        const auto fall = distanceAlong({0, -1, 0}, centredCube(), sunk, centredCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall + 0.1) < 1e-14);
    }
    /// A wall can move down between two neighbours that it touches, up to rounding.
    void touchingNeighboursSlideWithinTolerance() {
        const Vec3 down{0, -1, 0};
        for (const double between : {1.0, 1.0 - 1e-12, 1.0 - 5e-5}) {
            const Pose beside{.position = {between, 5.0, 0.0}};
            QVERIFY(!distanceAlong(down, centredCube(), beside, centredCube(), {}, 1e-4));
        }
        QVERIFY(distanceAlong(down, centredCube(), {.position = {0.99, 5.0, 0.0}}, centredCube(), {}, 1e-4));
    }
};

RUBBLE_TEST(HullOverlapTest)
#include "HullOverlapTest.moc"
