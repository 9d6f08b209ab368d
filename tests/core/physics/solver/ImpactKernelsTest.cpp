#include "core/physics/solver/ImpactKernels.h"

#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

using Scalar = ImpactKernels<1>;
using One = Floats<1>;

/// The cube with points below it that collide at these speeds, m/s, without impulses so far.
struct CollidingCube {
    OneContact contact;
    One residuals[4]{};
    One speeds[4]{};

    CollidingCube(const std::vector<Vec3f>& points, const std::vector<float>& residual) : contact(points) {
        contact.prepare(kernelsOf(SimdWidth::Scalar), 0.0f);
        for (std::size_t i = 0; i < points.size(); ++i) residuals[i] = speeds[i] = One{residual[i]};
    }
    Scalar::NormalImpulse solve() {
        const auto points = static_cast<int>(contact.block.pointCount[0]);
        return Scalar::solve(contact.block, 0, points, Scalar::impacts(residuals), residuals, speeds);
    }
};

}  // namespace

class ImpactKernelsTest : public QObject {
    Q_OBJECT
private slots:
    void impactsAreFasterThanTheLimit() {
        const auto isImpact = [](float speed) {
            const One residuals[4]{One{0.0f}, One{speed}, One{0.0f}, One{0.0f}};
            return Scalar::impacts(residuals)[0] != 0;
        };
        QVERIFY(isImpact(-0.11f));
        QVERIFY(isImpact(0.11f));
        QVERIFY(!isImpact(-0.09f));
    }
    /// Two corners that hit at 1 m/s together: 2 kg · 1 m/s, half at each.
    void flatImpactIsSharedEqually() {
        CollidingCube impact(kTwoPoints, {-1.0f, -1.0f});
        const auto impulses = impact.solve();
        QVERIFY(isClose(impact.contact.impulse(0), 1.0f));
        QVERIFY(isClose(impact.contact.impulse(1), 1.0f));
        QVERIFY(isClose(impulses.sum[0], 2.0f));
        QVERIFY(isClose(impulses.moment.x[0], 0.0f));
        QVERIFY(isClose(impact.speeds[0][0], 0.0f) && isClose(impact.speeds[1][0], 0.0f));
    }
    void fourCornersAreSolvedExactly() {
        CollidingCube impact(kFourCorners, {-1.0f, -1.0f, -1.0f, -1.0f});
        impact.solve();
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(isClose(impact.contact.impulse(i), 0.5f));
            QVERIFY(std::abs(impact.speeds[i][0]) < 1e-5f);
        }
    }
    /// The cube hits with one corner: the effective mass there is 1 / (1/2 + 3 · 0.25²) = 1.4545 kg.
    void oneCornerStopsWhereItIs() {
        CollidingCube impact({{0.25f, 0.0f, 0.0f}}, {-2.0f});
        const auto impulses = impact.solve();
        QVERIFY(isClose(impact.contact.impulse(0), 2.0f / 0.6875f));
        QVERIFY(isClose(impulses.moment.x[0], 0.5f / 0.6875f));
        QVERIFY(isClose(impact.speeds[0][0], 0.0f));
    }
    /// Where a point would have to pull, the manifold is left to the other passes: two corners, one fast, one resting.
    void manifoldsThatWouldPullAreLeftAsTheyAre() {
        CollidingCube impact(kTwoPoints, {-1.0f, 1.0f});  // stopping the rotation would need -2 N·s at the second
        const auto impulses = impact.solve();
        QCOMPARE(impact.contact.impulse(0), 0.0f);
        QCOMPARE(impulses.sum[0], 0.0f);
        QCOMPARE(impact.speeds[0][0], -1.0f);
    }
    /// What a point has already counts: it may lose that much.
    void earlierImpulsesMayBeTakenBack() {
        CollidingCube impact(kTwoPoints, {-1.0f, 1.0f});
        impact.contact.impulse(0) = impact.contact.impulse(1) = 10.0f;
        impact.solve();
        // An impulse pair ± J changes the corners' speeds by 2 · 3 · 0.25² J = 0.375 J.
        QVERIFY(isClose(impact.contact.impulse(0), 10.0f + 1.0f / 0.375f));
        QVERIFY(isClose(impact.contact.impulse(1), 10.0f - 1.0f / 0.375f));
    }
    void slowManifoldsAreLeftAsTheyAre() {
        CollidingCube impact(kTwoPoints, {-0.09f, -0.09f});
        impact.solve();
        QCOMPARE(impact.contact.impulse(0), 0.0f);
    }
};

RUBBLE_TEST(ImpactKernelsTest)
#include "ImpactKernelsTest.moc"
