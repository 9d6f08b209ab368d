// Tests core/physics/step/WarmStart.cpp: what no longer balances throws nothing.
#include "core/physics/step/WarmStart.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Thin splinters, one on the other, and a heavy block on them, on a fixed table: bodies 1 to `count` are the
/// splinters.
BodyScene pressedSplinters(Random& random, int count, double width) {
    BodyScene scene;
    addFixedBox(scene, "table", {-2.0, -1.0, -2.0}, {2.0, 0.0, 2.0});
    double top = 0.0;
    for (int k = 0; k < count; ++k) {
        const double thickness = width * random.between(0.05, 0.3);
        const Vec3 size(width * random.between(0.5, 1.5), thickness, width * random.between(0.5, 1.5));
        const Vec3 at(width * random.between(-0.1, 0.1), top + 0.5 * thickness, width * random.between(-0.1, 0.1));
        addFreeBody(scene, "splinter " + std::to_string(k), addShape(scene, {boxOf(size)}), {.position = at});
        top += thickness;
    }
    addFreeBody(scene, "block", addShape(scene, {boxOf(Vec3(12.0 * width))}),
                {.position = {0.0, top + 6.0 * width, 0.0}});
    return scene;
}

double fastest(const SceneWorld& made) {
    double speed = 0.0;
    for (const BodyId body : made.bodies) {
        if (made.world.contains(body)) speed = std::max(speed, glm::length(made.world.state(body).velocity));
    }
    return speed;
}

}  // namespace

class WarmStartTest : public QObject {
    Q_OBJECT
private slots:
    /// The table is taken away: all fall, none faster than gravity has it.
    void pressedSplintersFallWithTheirBlock_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("width");
        for (const int count : {1, 2, 3, 5}) {
            for (const double width : {0.02, 0.1, 0.5}) QTest::addRow("%d of %g m", count, width) << count << width;
        }
    }
    void pressedSplintersFallWithTheirBlock() {
        QFETCH(int, count);
        QFETCH(double, width);
        Random random(static_cast<std::uint64_t>(count) * 100 + static_cast<std::uint64_t>(1000.0 * width));
        for (int round = 0; round < 5; ++round) {
            SceneWorld made = worldOf(pressedSplinters(random, count, width), {.sleeping = false});
            simulate(made.world, 1.0);
            made.world.removeBody(made.bodies[0]);
            double most = 0.0;
            for (int step = 1; step <= 6; ++step) {
                made.world.step(kStep);
                most = std::max(most, fastest(made) - step * 9.81 * kStep);
            }
            // Splinters that were pressed into each other are pushed apart, too.
            QVERIFY2(most < 1.5, QByteArray::number(most) + " m/s, round " + QByteArray::number(round));
        }
    }
};

RUBBLE_TEST(WarmStartTest)
#include "WarmStartTest.moc"
