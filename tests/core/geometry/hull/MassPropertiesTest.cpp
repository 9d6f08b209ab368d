#include "core/base/Random.h"
#include "core/geometry/hull/MassProperties.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rubble;

namespace {

Ring rectangleOfSize(double width, double height, Vec2 corner = {0.0, 0.0}) {
    return rectangle(corner, corner + Vec2(width, height));
}

double largestDifference(const Mat3& a, const Mat3& b) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
    }
    return largest;
}

Mat3 diagonal(double x, double y, double z) { return Mat3{{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }

}  // namespace

class MassPropertiesTest : public QObject {
    Q_OBJECT
private slots:
    void boxHasTheTextbookTensor() {
        // 2 x 4 x 6, volume 48: inertia volume / 12 times the sums of two squared sides.
        const MassProperties prism = massOfPrism({rectangleOfSize(2.0, 4.0), {}}, 6.0);
        QCOMPARE(prism.volume, 48.0);
        QVERIFY(prism.centre == Vec3(1.0, 2.0, 0.0));
        QVERIFY(largestDifference(prism.inertia, diagonal(208.0, 160.0, 80.0)) < 1e-12);
        const MassProperties polytope = massOf(extruded(rectangleOfSize(2.0, 4.0), -3.0, 3.0));
        QCOMPARE(polytope.volume, 48.0);
        QVERIFY(glm::distance(polytope.centre, Vec3(1.0, 2.0, 0.0)) < 1e-15);
        QVERIFY(largestDifference(polytope.inertia, diagonal(208.0, 160.0, 80.0)) < 1e-12);
    }
    void triangleHasAProductOfInertia() {
        // Right triangle with legs 1 along x and y, depth 1: about the centroid the integral of x² is 1/36, of xy
        // -1/72.
        const MassProperties mass = massOfPrism({{{0, 0}, {1, 0}, {0, 1}}, {}}, 1.0);
        QCOMPARE(mass.volume, 0.5);
        QVERIFY(glm::distance(mass.centre, Vec3(1.0 / 3.0, 1.0 / 3.0, 0.0)) < 1e-15);
        QVERIFY(std::abs(mass.inertia[2][2] - 2.0 / 36.0) < 1e-15);
        QVERIFY(std::abs(mass.inertia[0][1] - 1.0 / 72.0) < 1e-15);  // minus the integral
        QVERIFY(std::abs(mass.inertia[0][0] - (1.0 / 36.0 + 0.5 / 12.0)) < 1e-15);
    }
    void holeIsSubtractedForAnyWinding() {
        Ring hole = rectangleOfSize(1.0, 1.0, {0.5, 0.5});
        const MassProperties counterClockwise = massOfPrism({rectangleOfSize(4.0, 2.0), {hole}}, 1.0);
        std::reverse(hole.begin(), hole.end());
        const MassProperties clockwise = massOfPrism({rectangleOfSize(4.0, 2.0), {hole}}, 1.0);
        QCOMPARE(counterClockwise.volume, 7.0);
        QCOMPARE(clockwise.volume, 7.0);
        // (8 * 2 - 1 * 1) / 7 along x, the middle along y.
        QVERIFY(glm::distance(clockwise.centre, Vec3(15.0 / 7.0, 1.0, 0.0)) < 1e-15);
        QVERIFY(largestDifference(clockwise.inertia, counterClockwise.inertia) < 1e-14);
        Ring outer = rectangleOfSize(4.0, 2.0);
        std::reverse(outer.begin(), outer.end());
        QCOMPARE(massOfPrism({outer, {hole}}, 1.0).volume, 7.0);
    }
    void massIsAccurateFarFromTheOrigin() {
        // 2^-20 m wide, 2^20 m from the origin: every coordinate is exact, so must the volume be.
        const double side = 0x1p-20;
        const Vec2 far{0x1p20, -0x1p20};
        const MassProperties prism = massOfPrism({rectangleOfSize(side, side, far), {}}, 1.0);
        QCOMPARE(prism.volume, side * side);
        QVERIFY(prism.centre == Vec3(far.x + side / 2, far.y + side / 2, 0.0));
        QVERIFY(std::abs(prism.inertia[2][2] / (side * side * side * side / 6.0) - 1.0) < 1e-14);
        const MassProperties polytope = massOf(extruded(rectangleOfSize(side, side, far), 0.0, side));
        QVERIFY(std::abs(polytope.volume / (side * side * side) - 1.0) < 1e-14);
        QVERIFY(std::abs(polytope.inertia[0][0] / (side * side * side * side * side / 6.0) - 1.0) < 1e-13);
    }
    void emptyPolytopeHasNoMass() {
        QCOMPARE(massOfPrism(Polygon(), 1.0).volume, 0.0);
        QCOMPARE(massOf({}).volume, 0.0);
        QCOMPARE(combined({}).volume, 0.0);
        const MassProperties flat = massOfPrism({{{0, 0}, {1, 0}, {2, 0}}, {}}, 1.0);
        QCOMPARE(flat.volume, 0.0);
        QVERIFY(flat.centre == Vec3(1.0, 0.0, 0.0));  // the mean of the corners
    }
    void halvesCombineToTheWhole() {
        const MassProperties whole = massOf(extruded(rectangleOfSize(2.0, 1.0), 0.0, 1.0));
        const MassProperties halves[] = {massOf(extruded(rectangleOfSize(0.5, 1.0), 0.0, 1.0)),
                                         massOf(extruded(rectangleOfSize(1.5, 1.0, {0.5, 0.0}), 0.0, 1.0))};
        const MassProperties sum = combined(halves);
        QVERIFY(std::abs(sum.volume - 2.0) < 1e-15);
        QVERIFY(glm::distance(sum.centre, Vec3(1.0, 0.5, 0.5)) < 1e-15);
        QVERIFY(largestDifference(sum.inertia, whole.inertia) < 1e-14);
    }
    void someOfSeveralBodiesCombine() {
        const MassProperties bodies[] = {massOf(extruded(rectangleOfSize(0.5, 1.0), 0.0, 1.0)),
                                         massOf(extruded(rectangleOfSize(9.0, 9.0), 0.0, 1.0)),
                                         massOf(extruded(rectangleOfSize(1.5, 1.0, {0.5, 0.0}), 0.0, 1.0))};
        const MassProperties some = combined(bodies, std::vector<std::uint32_t>{2, 0});
        const MassProperties same = combined(std::vector{bodies[2], bodies[0]});
        QVERIFY(some.volume == same.volume && some.centre == same.centre && some.inertia == same.inertia);
        QCOMPARE(combined(bodies, {}).volume, 0.0);
    }
    void prismAndPolytopeAgreeOnRandomTriangles() {
        const std::uint64_t seed = 5;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int round = 0; round < 1000; ++round) {
            Ring ring;
            for (int i = 0; i < 3; ++i) ring.push_back({random.between(-1, 1), random.between(-1, 1)});
            if (cross(ring[1] - ring[0], ring[2] - ring[0]) < 0.0) std::swap(ring[0], ring[1]);
            if (cross(ring[1] - ring[0], ring[2] - ring[0]) < 1e-6) continue;
            const MassProperties prism = massOfPrism({ring, {}}, 2.0);
            const MassProperties polytope = massOf(extruded(ring, -1.0, 1.0));
            QVERIFY(std::abs(prism.volume - polytope.volume) < 1e-14);
            QVERIFY(glm::distance(prism.centre, polytope.centre) < 1e-15 / prism.volume);
            QVERIFY(largestDifference(prism.inertia, polytope.inertia) < 1e-13);
        }
    }
};

RUBBLE_TEST(MassPropertiesTest)
#include "MassPropertiesTest.moc"
