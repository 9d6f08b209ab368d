// Tests core/physics/step/SharedLoad.cpp.
#include "core/physics/step/SharedLoad.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/BodyShapes.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;

class SharedLoadTest : public QObject {
    Q_OBJECT
private slots:
    /// What 2, 3, ... manifolds leave of the speed, one after the other, is what one leaves.
    void togetherTheyAreAsSoftAsOne() {
        const Softness one{.biasRate = 30.0f, .massScale = 0.84f, .impulseScale = 0.16f};
        for (const int count : {2, 3, 5}) {
            const Softness shared = sharedSoftness(one, count);
            double left = 1.0;
            for (int k = 0; k < count; ++k) left *= 1.0 - static_cast<double>(shared.massScale);
            QVERIFY(std::abs(left - 0.16) < 1e-6);
            QCOMPARE(shared.biasRate, one.biasRate);
            QVERIFY(shared.impulseScale <= 0.9f);
        }
    }
    void aloneItKeepsItsSoftness() {
        const Softness one{.biasRate = 30.0f, .massScale = 0.84f, .impulseScale = 0.16f};
        const Softness shared = sharedSoftness(one, 1.0);
        QVERIFY(std::abs(shared.massScale - one.massScale) < 1e-6f);
        QVERIFY(std::abs(shared.impulseScale - one.impulseScale) < 1e-6f);
    }
    /// Eight beams lie on eight: each pair of frames has up to a dozen manifolds.
    void framesStandAndSleep() {
        BodyScene scene;
        test::addGround(scene, 10.0);
        const std::uint32_t shape = test::addShape(scene, test::frameHulls(1.0, 0.1, 0.1));
        for (int k = 0; k < 8; ++k) {
            test::addFreeBody(scene, std::to_string(k), shape, {.position = {0.002 * (k % 3), 0.05 + 0.1 * k, 0.0}});
        }
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 2.0);
        QVERIFY(test::areAllAsleep(moved));
        QVERIFY(test::farthestMoved(scene, moved) < 0.01);
    }
};

RUBBLE_TEST(SharedLoadTest)
#include "SharedLoadTest.moc"
