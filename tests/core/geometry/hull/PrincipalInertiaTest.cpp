#include "core/base/Random.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/PrincipalInertia.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

double tensorDifference(const Mat3& a, const Mat3& b) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    return largest;
}

Mat3 diagonalTensor(double x, double y, double z) { return {{x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}}; }

/// A rotation by a random angle about a random axis, of rational numbers.
Quat randomRotation(Random& random) {
    return glm::normalize(
        Quat(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5 + 1e-3));
}

}  // namespace

class PrincipalInertiaTest : public QObject {
    Q_OBJECT
private slots:
    void boxHasTheAnalyticMoments() {
        // m/12 (b² + c²): of 1 x 2 x 3 m at density 1, with m = 6 kg, 6.5, 5 and 2.5 kg·m².
        const Mat3 tensor = massOf(extruded(Ring{{0, 0}, {1, 0}, {1, 2}, {0, 2}}, 0.0, 3.0)).inertia;
        const PrincipalInertia inertia = principalInertia(tensor);
        QVERIFY(glm::distance(inertia.moments, Vec3(6.5, 5.0, 2.5)) < 1e-12);
        QVERIFY(tensorDifference(tensorOf(inertia), tensor) < 1e-12);
    }
    void descendingMomentsKeepTheBodysAxes() {
        const PrincipalInertia inertia = principalInertia(diagonalTensor(3.0, 2.0, 1.0));
        QVERIFY(inertia == (PrincipalInertia{Vec3(3.0, 2.0, 1.0), Quat(1.0, 0.0, 0.0, 0.0)}));
    }
    void equalMomentsKeepTheBodysAxes() {
        const Quat none(1.0, 0.0, 0.0, 0.0);
        QVERIFY(principalInertia(diagonalTensor(2.0, 2.0, 2.0)).rotation == none);
        QVERIFY(principalInertia(diagonalTensor(2.0, 2.0, 1.0)).rotation == none);
        QVERIFY(principalInertia(diagonalTensor(2.0, 2.0 + 1e-13, 1.0)).rotation == none);
        Mat3 rounded = diagonalTensor(2.0, 2.0, 1.0);
        rounded[0][1] = rounded[1][0] = 1e-16;
        QVERIFY(principalInertia(rounded).rotation == none);
    }
    void rotatedTensorsAreDiagonalizedWithFixedSigns() {
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Random random(seed);
            const Mat3 axes = glm::mat3_cast(randomRotation(random));
            const Vec3 moments(3.0 + random.unit(), 1.5 + random.unit(), 0.2 + random.unit());
            const Mat3 tensor = axes * diagonalTensor(moments.x, moments.y, moments.z) * glm::transpose(axes);
            const Mat3 symmetric = (tensor + glm::transpose(tensor)) * 0.5;
            const PrincipalInertia inertia = principalInertia(symmetric);
            const Mat3 found = glm::mat3_cast(inertia.rotation);
            QVERIFY2(glm::distance(inertia.moments, moments) < 1e-13 * 10.0, std::to_string(seed).c_str());
            QVERIFY2(tensorDifference(tensorOf(inertia), symmetric) < 1e-13 * 10.0, std::to_string(seed).c_str());
            QVERIFY(inertia.rotation.w >= 0.0);
            for (int k = 0; k < 2; ++k) {
                const double most = std::max({found[k].x, found[k].y, found[k].z});
                const double least = std::min({found[k].x, found[k].y, found[k].z});
                QVERIFY2(most >= -least * (1.0 - 1e-8), std::to_string(seed).c_str());
            }
        }
    }
};

RUBBLE_TEST(PrincipalInertiaTest)
#include "PrincipalInertiaTest.moc"
