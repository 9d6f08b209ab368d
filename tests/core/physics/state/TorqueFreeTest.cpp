// Tests core/physics/state/TorqueFree.cpp.
#include "core/physics/state/TorqueFree.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// A body with the principal moments of inertia of a box with sides of a given length, at a mass of 12 kg.
Body boxBody(float x, float y, float z) {
    Body body;
    body.inertia = {y * y + z * z, 0.0f, 0.0f, x * x + z * z, 0.0f, x * x + y * y};
    body.inverseInertia = {1.0f / body.inertia.xx, 0.0f, 0.0f, 1.0f / body.inertia.yy, 0.0f, 1.0f / body.inertia.zz};
    return body;
}

Vec3f momentumOf(const Body& body, const TorqueFreeMotion& motion) {
    return motion.rotation.matrix() * (body.inertia * motion.angularVelocity);
}

double energyOf(const Body& body, Vec3f w) { return 0.5 * static_cast<double>(dot(w, body.inertia * w)); }

}  // namespace

class TorqueFreeTest : public QObject {
    Q_OBJECT
private slots:
    /// Of a body of equal moments all angular velocities are constant.
    void cubeKeepsItsAngularVelocity() {
        const Vec3f w(3.0f, -4.0f, 12.0f);
        const std::optional<Vec3f> mean = meanAngularVelocity(boxBody(1.0f, 1.0f, 1.0f), w, 0.03f);
        QVERIFY(mean && length(*mean - w) < 1e-5f);
    }
    /// A disc's angular velocity precesses about its axis at (Iz - Ix) / Ix wz: here 0.8 rad/s, as sides of 1, 1 and
    /// 1/3 m have moments of 10/9, 10/9 and 2.
    void discPrecesses() {
        const Body disc = boxBody(1.0f, 1.0f, 1.0f / 3.0f);
        const TorqueFreeMotion after = advanced(disc, {{}, Vec3f(0.1f, 0.0f, 1.0f)}, 1.0f);
        QVERIFY(std::abs(after.angularVelocity.z - 1.0f) < 1e-6f);
        // The implicit midpoint rule precesses by 2 atan(0.4 / 3) in each of three steps.
        const double angle = 6.0 * std::atan(0.4 / 3.0);
        QVERIFY(std::abs(after.angularVelocity.x - 0.1 * std::cos(angle)) < 1e-6);
        QVERIFY(std::abs(after.angularVelocity.y - 0.1 * std::sin(angle)) < 1e-6);
    }
    void energyAndMomentumAreKept_data() {
        QTest::addColumn<float>("length");
        QTest::addColumn<float>("thickness");
        QTest::addColumn<float>("angle");  // rad per step
        for (const float length : {1.0f, 20.0f, 60.0f, 100.0f}) {
            for (const float thickness : {1.0f, 0.2f}) {
                for (const float angle : {0.001f, 0.1f, 2.0f, 15.0f, 200.0f}) {
                    QTest::addRow("%g : 1 : %g, %g rad", static_cast<double>(length), static_cast<double>(thickness),
                                  static_cast<double>(angle))
                        << length << thickness << angle;
                }
            }
        }
    }
    void energyAndMomentumAreKept() {
        QFETCH(float, length);
        QFETCH(float, thickness);
        QFETCH(float, angle);
        const Body body = boxBody(length, 1.0f, thickness);
        const Vec3f axis = normalized(Vec3f(0.7f, 0.5f, -0.5f));
        TorqueFreeMotion motion{{}, axis * angle};
        const Vec3f momentum = momentumOf(body, motion);
        const double energy = energyOf(body, motion.angularVelocity);
        for (int step = 0; step < 300; ++step) motion = advanced(body, motion, 1.0f);
        const double gain = energyOf(body, motion.angularVelocity) / energy - 1.0;
        const float drift = rubble::length(momentumOf(body, motion) - momentum) / rubble::length(momentum);
        // Single precision, 300 steps of up to 30 parts.
        QVERIFY2(std::abs(gain) < 1e-3, qPrintable(QString::number(gain)));
        QVERIFY2(drift < 1e-2f, qPrintable(QString::number(static_cast<double>(drift))));
    }
    /// Beyond half a radian, one step is refused.
    void tooFarIsRefused() { QVERIFY(!meanAngularVelocity(boxBody(9.0f, 1.0f, 1.0f), Vec3f(0.0f, 6.0f, 1.0f), 0.1f)); }
};

RUBBLE_TEST(TorqueFreeTest)
#include "TorqueFreeTest.moc"
