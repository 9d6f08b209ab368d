// Tests core/physics/step/Displacement.cpp.
#include "core/physics/step/Displacement.h"

#include "core/physics/world/Bodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;

namespace {

/// A cube of 1 m and 1000 kg that falls at a speed and spins, in earth's gravity.
WorldState fallingCube(double speed) {
    WorldState state;
    state.gravity = Vec3f(0.0f, -9.81f, 0.0f);
    state.colours.resizeBodies(1);
    addBody(state,
            {.shape = test::boxShape(Vec3(1.0)), .velocity = {0.0, -speed, 0.0}, .angularVelocity = {0.0, speed, 0.0}});
    state.motions[1].deltaPosition = Vec3f(0.0f, -0.1f, 0.0f);
    return state;
}

/// J.
double kineticOf(const WorldState& state) {
    const BodyMotion& motion = state.motions[1];
    return 0.5 * static_cast<double>(state.bodies[1].mass * lengthSquared(motion.velocity) +
                                     dot(motion.angularVelocity, state.bodies[1].inertia * motion.angularVelocity));
}

}  // namespace

class DisplacementTest : public QObject {
    Q_OBJECT
private slots:
    void heightIsPaidFor() {
        WorldState state = fallingCube(3.0);
        const double before = kineticOf(state);
        correctDisplacement(state, 1, Vec3f(0.05f, -0.06f, 0.0f));
        QCOMPARE(state.motions[1].deltaPosition, Vec3f(0.05f, -0.06f, 0.0f));
        QVERIFY(std::abs(before - kineticOf(state) - 1000.0 * 9.81 * 0.04) < 1.0);
    }
    void noMoreThanItHas() {
        WorldState state = fallingCube(0.1);
        correctDisplacement(state, 1, Vec3f(0.0f));
        QCOMPARE(kineticOf(state), 0.0);
    }
    void whatSinksKeepsItsMotion() {
        WorldState state = fallingCube(3.0);
        const double before = kineticOf(state);
        correctDisplacement(state, 1, Vec3f(0.0f, -0.2f, 0.0f));
        QCOMPARE(kineticOf(state), before);
    }
};

RUBBLE_TEST(DisplacementTest)
#include "DisplacementTest.moc"
