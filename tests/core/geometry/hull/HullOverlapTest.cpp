#include "core/base/Random.h"
#include "core/geometry/hull/HullOverlap.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

/// A unit cube centred at the origin.
Polytope unitCube() { return extruded(Ring{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, -0.5, 0.5); }

HullOverlap cubesApart(Vec3 between) { return hullOverlap(unitCube(), translated(unitCube(), between)); }

bool isNear(const HullOverlap& overlap, double depth, Vec3 normal) {
    return std::abs(overlap.depth - depth) < 1e-14 && glm::distance(overlap.normal, normal) < 1e-14;
}

Quat turned(double angle, Vec3 axis) { return glm::angleAxis(angle, axis); }

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
        QVERIFY(isNear(hullOverlap(big, translated(unitCube(), {1.0, 0.0, 0.0})), 1.5, {1, 0, 0}));
    }
    void swappingNegatesTheNormal() {
        const Polytope other = translated(unitCube(), {0.9, 0.0, 0.0});
        QVERIFY(isNear(hullOverlap(other, unitCube()), 0.1, {-1, 0, 0}));
    }
    void edgeOnEdgeUsesTheCrossProduct() {
        // Both cubes stand on an edge, along x and along y: half a diagonal each, so they touch at a distance of √2.
        const double quarter = std::numbers::pi / 4.0;
        const Pose below{{0.0, 0.0, 0.0}, turned(quarter, {1, 0, 0})};
        const Pose touching{{0.0, 0.0, std::numbers::sqrt2}, turned(quarter, {0, 1, 0})};
        QVERIFY(isNear(hullOverlap(unitCube(), below, unitCube(), touching), 0.0, {0, 0, 1}));
        const Pose deep{{0.0, 0.0, std::numbers::sqrt2 - 0.1}, turned(quarter, {0, 1, 0})};
        QVERIFY(isNear(hullOverlap(unitCube(), below, unitCube(), deep), 0.1, {0, 0, 1}));
    }
    void posesAreApplied() {
        // A rotation by 90 degrees about z moves the longer side from x to y.
        const Polytope plank = extruded(Ring{{-2, -0.5}, {2, -0.5}, {2, 0.5}, {-2, 0.5}}, -0.5, 0.5);
        const Pose upright{{0.0, 2.4, 0.0}, turned(std::numbers::pi / 2.0, {0, 0, 1})};
        QVERIFY(isNear(hullOverlap(unitCube(), Pose{}, plank, upright), 0.1, {0, 1, 0}));
    }
    void depthIsAccurateFarFromTheOrigin() {
        const Vec3 far{1e6, -1e6, 1e6};
        const Polytope a = translated(unitCube(), far);
        const Polytope b = translated(unitCube(), far + Vec3(0.75, 0.0, 0.0));
        QVERIFY(isNear(hullOverlap(a, b), 0.25, {1, 0, 0}));
        const HullOverlap posed = hullOverlap(unitCube(), {far, turned(0, {0, 0, 1})}, unitCube(),
                                              {far + Vec3(0.75, 0.0, 0.0), turned(0, {0, 0, 1})});
        QVERIFY(isNear(posed, 0.25, {1, 0, 0}));
    }
    void separatingByTheDepthMakesThemTouch() {
        const std::uint64_t seed = 9;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        const auto between = [&](double low, double high) { return random.between(low, high); };
        for (int round = 0; round < 200; ++round) {
            const Vec3 axis = glm::normalize(Vec3(between(-1, 1), between(-1, 1), between(0.1, 1)));
            const Pose first{{0, 0, 0}, turned(between(0, 3), axis)};
            Pose second{{between(-1, 1), between(-1, 1), between(-1, 1)}, turned(between(0, 3), {0, 0, 1})};
            const HullOverlap overlap = hullOverlap(unitCube(), first, unitCube(), second);
            if (overlap.depth < 0.0) continue;
            second.position += overlap.depth * overlap.normal;
            QVERIFY(std::abs(hullOverlap(unitCube(), first, unitCube(), second).depth) < 1e-14);
            second.position += 0.5 * overlap.normal;
            QVERIFY(hullOverlap(unitCube(), first, unitCube(), second).depth <= -0.5 + 1e-14);
        }
    }
    void distanceAlongEndsAtContact() {
        const Pose above{.position = {0.2, 5.0, 0.3}};
        const auto fall = distanceAlong({0, -1, 0}, unitCube(), above, unitCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall - 4.0) < 1e-14);
        QVERIFY(!distanceAlong({0, 1, 0}, unitCube(), above, unitCube(), {}, 1e-4));
    }
    /// The downward corner is half the cube's diagonal below the centre.
    void rotatedCubeTouchesWithItsCorner() {
        const Pose tilted{{0.0, 5.0, 0.0}, turned(std::numbers::pi / 4.0, {0, 0, 1})};
        const auto fall = distanceAlong({0, -1, 0}, unitCube(), tilted, unitCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall - (4.5 - std::sqrt(0.5))) < 1e-14);
    }
    void overlapGivesNegativeDistance() {
        const Pose sunk{.position = {0.0, 0.9, 0.0}};
        const auto fall = distanceAlong({0, -1, 0}, unitCube(), sunk, unitCube(), {}, 1e-4);
        QVERIFY(fall && std::abs(*fall + 0.1) < 1e-14);
    }
    /// A wall can move down between two neighbours that it touches, up to rounding.
    void touchingNeighboursSlideWithinTolerance() {
        const Vec3 down{0, -1, 0};
        for (const double between : {1.0, 1.0 - 1e-12, 1.0 - 5e-5}) {
            const Pose beside{.position = {between, 5.0, 0.0}};
            QVERIFY(!distanceAlong(down, unitCube(), beside, unitCube(), {}, 1e-4));
        }
        QVERIFY(distanceAlong(down, unitCube(), {.position = {0.99, 5.0, 0.0}}, unitCube(), {}, 1e-4));
    }
};

RUBBLE_TEST(HullOverlapTest)
#include "HullOverlapTest.moc"
