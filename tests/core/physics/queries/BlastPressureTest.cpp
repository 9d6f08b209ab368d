#include "core/physics/queries/BlastPressure.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// A square of side `side` at the distance `x` that faces the centre, which is the origin.
FacePolygon squareAt(double x, double side) {
    const double h = 0.5 * side;
    return {{x, -h, -h}, {x, -h, h}, {x, h, h}, {x, h, -h}};
}

BlastSum sumOf(const FacePolygon& face, const BlastPressure& blast) {
    BlastSum sum;
    addBlastOn(face, blast, sum);
    return sum;
}

}  // namespace

class BlastPressureTest : public QObject {
    Q_OBJECT
private slots:
    /// A square centimetre at half of the radius: 1000 N·s/m² · (1 - 1/2) · 10⁻⁴ m², away from the centre.
    void smallFaceGetsPressureTimesArea() {
        const BlastSum sum = sumOf(squareAt(2.0, 0.01), {.impulse = 1000.0, .radius = 4.0});
        QVERIFY(std::abs(sum.impulse.x - 0.05) < 1e-4 * 0.05);
        QVERIFY(std::abs(sum.impulse.y) < 1e-12 && std::abs(sum.impulse.z) < 1e-12);
        QVERIFY(std::abs(sum.size - 0.05) < 1e-4 * 0.05);
        QVERIFY(glm::distance(sum.weightedPoint / sum.size, Vec3(2.0, 0.0, 0.0)) < 1e-4);
    }
    void impulseFallsLinearlyToTheRadius() {
        const BlastPressure blast{.impulse = 1000.0, .radius = 4.0};
        for (const double distance : {0.5, 1.0, 3.0, 3.9}) {
            const double expected = 1000.0 * (1.0 - distance / 4.0) * 1e-6;
            QVERIFY(std::abs(sumOf(squareAt(distance, 0.001), blast).impulse.x - expected) < 2e-3 * expected);
        }
        QCOMPARE(sumOf(squareAt(4.01, 0.001), blast).size, 0.0);
    }
    /// The same face seen at 60 degrees gets cos 60° = 1/2, along the line of sight.
    void slantedFacesGetLess() {
        const double c = 0.5, s = std::sqrt(0.75);
        FacePolygon face = squareAt(0.0, 0.01);
        for (Vec3& corner : face)
            corner = Vec3(2.0 + corner.x * c - corner.y * s, corner.x * s + corner.y * c, corner.z);
        const BlastSum sum = sumOf(face, {.impulse = 1000.0, .radius = 4.0});
        QVERIFY(std::abs(sum.impulse.x - 0.025) < 1e-3 * 0.025);
        QVERIFY(std::abs(sum.impulse.y) < 1e-4);
    }
    /// A side of a cube about the centre, 1 m away. With the pressure P (1 - d/R), the impulse along x is the integral
    /// of P (1 - d/R) x²/d² over the face; for a far radius, 4 · 0.6394 P.
    void largeFaceIsIntegrated() {
        const BlastSum sum = sumOf(squareAt(1.0, 2.0), {.impulse = 1.0, .radius = 1e9});
        double expected = 0.0;
        constexpr int kCells = 1000;
        for (int i = 0; i < kCells; ++i) {
            for (int j = 0; j < kCells; ++j) {
                const double y = -1.0 + 2.0 * (i + 0.5) / kCells, z = -1.0 + 2.0 * (j + 0.5) / kCells;
                expected += 4.0 / (kCells * kCells) / (1.0 + y * y + z * z);
            }
        }
        QVERIFY(std::abs(expected - 4.0 * 0.6394) < 1e-3);
        QVERIFY(std::abs(sum.impulse.x - expected) < 2e-3 * expected);
        QVERIFY(glm::distance(sum.weightedPoint / sum.size, Vec3(1.0, 0.0, 0.0)) < 1e-6);
    }
    /// The impulses act along a line through the centre: the sum of the points lies on it.
    void sumActsThroughTheCentre() {
        FacePolygon face = squareAt(1.0, 1.0);
        for (Vec3& corner : face) corner += Vec3(0.0, 0.7, -0.3);
        const BlastSum sum = sumOf(face, {.impulse = 10.0, .radius = 3.0});
        QVERIFY(sum.size > glm::length(sum.impulse));
        QVERIFY(glm::dot(glm::normalize(sum.impulse), glm::normalize(sum.weightedPoint)) > 0.99);
    }
};

RUBBLE_TEST(BlastPressureTest)
#include "BlastPressureTest.moc"
