#include "core/play/breaking/SharedImpacts.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A box of 1 m and 1000 kg above fixed blocks at places along x, m, that falls on them at 2 m/s.
struct FallingBox {
    World world{{.gravity = Vec3(0.0)}};
    BodyId box;

    explicit FallingBox(const std::vector<double>& places, double restitution = 0.0) {
        const auto cube = *makeShape(std::vector{boxOf(Vec3(1.0))}), block = *makeShape(std::vector{boxOf(Vec3(0.1))});
        box = *world.addBody({.shape = cube, .velocity = {0.0, -2.0, 0.0}, .restitution = restitution});
        for (const double x : places)
            (void)*world.addBody({.shape = block, .kind = BodyKind::Static, .pose = {.position = {x, -0.56, 0.0}}});
    }
    std::vector<Impact> impacts() {
        world.collide(1.0 / 60.0);
        return world.impacts();
    }
};

double sumOf(const std::vector<Impact>& impacts) {
    double sum = 0.0;
    for (const Impact& impact : impacts) sum += impact.impulse();
    return sum;
}

}  // namespace

class SharedImpactsTest : public QObject {
    Q_OBJECT
private slots:
    void oneImpactIsAsItWas() {
        FallingBox falling({0.2});
        const std::vector<Impact> impacts = falling.impacts();
        QCOMPARE(impacts.size(), 1u);
        QCOMPARE(sharedImpacts(falling.world, impacts)[0].impulse(), impacts[0].impulse());
    }
    void boxOnTwoBlocksGivesThemWhatItHas() {
        FallingBox falling({-0.3, 0.3});
        const std::vector<Impact> impacts = falling.impacts();
        QCOMPARE(impacts.size(), 2u);
        QVERIFY(sumOf(impacts) > 2500.0);
        const std::vector<Impact> shared = sharedImpacts(falling.world, impacts);
        for (const Impact& impact : shared) QVERIFY(std::abs(impact.impulse() - 1000.0) < 2.0);
    }
    void blocksBesideTheCentreShareByLeverage() {
        FallingBox falling({-0.1, 0.4});
        const std::vector<Impact> shared = sharedImpacts(falling.world, falling.impacts());
        QCOMPARE(shared.size(), 2u);
        QVERIFY(std::abs(shared[0].impulse() - 1600.0) < 8.0);  // 0.4 / 0.5 of 2000 N·s
        QVERIFY(std::abs(shared[1].impulse() - 400.0) < 8.0);
    }
    void restitutionReturnsTheApproach() {
        FallingBox falling({-0.3, 0.3}, 0.5);
        QVERIFY(std::abs(sumOf(sharedImpacts(falling.world, falling.impacts())) - 3000.0) < 6.0);
    }
    /// Three blocks in a row: any shares of them stop the box. Those of equal places are equal.
    void sharesDoNotDependOnTheOrder() {
        std::vector<double> places{-0.3, 0.0, 0.3};
        do {
            FallingBox falling(places);
            const std::vector<Impact> shared = sharedImpacts(falling.world, falling.impacts());
            QVERIFY(std::abs(sumOf(shared) - 2000.0) < 4.0);
            for (const Impact& one : shared) {
                for (const Impact& other : shared) {
                    if (std::abs(one.point.x + other.point.x) < 1e-3)
                        QVERIFY(std::abs(one.impulse() - other.impulse()) < 2.0);
                }
            }
        } while (std::ranges::next_permutation(places).found);
    }
    void togetherTheyAreNoMoreThanTheBodyHas() {
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            Random random(seed);
            std::vector<double> places;
            for (std::uint64_t k = 0, count = 1 + random.below(8); k < count; ++k)
                places.push_back(random.between(-0.5, 0.5));
            FallingBox falling(places);
            const std::vector<Impact> impacts = falling.impacts(), shared = sharedImpacts(falling.world, impacts);
            QVERIFY2(sumOf(shared) < 2000.0 * 1.01, qPrintable(QString("seed %1: %2").arg(seed).arg(sumOf(shared))));
            for (std::size_t k = 0; k < shared.size(); ++k) QVERIFY(shared[k].impulse() <= impacts[k].impulse());
        }
    }
};

RUBBLE_TEST(SharedImpactsTest)
#include "SharedImpactsTest.moc"
