// Tests core/physics/step/EnergyLimit.cpp: contacts give no energy, and the limit changes no momentum.
#include "core/physics/step/EnergyLimit.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

Vec3 sizeIn(Random& random, double low, double high) {
    return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

/// Heavy blocks on a light one.
BodyScene heavyOnLight(Random& random, double ratio, double drop) {
    BodyScene scene;
    addGround(scene, 20.0);
    const Vec3 light = sizeIn(random, 0.2, 0.6);
    addFreeBody(scene, "light", addShape(scene, {boxOf(light)}), {.position = {0.0, 0.5 * light.y, 0.0}});
    scene.bodies.back().density = 10.0;
    double top = light.y + drop;
    for (int k = 0; k < 2; ++k) {
        const Vec3 size = sizeIn(random, 0.5, 1.5);
        const Vec3 at(random.between(-0.1, 0.1), top + 0.5 * size.y, random.between(-0.1, 0.1));
        addFreeBody(scene, "heavy " + std::to_string(k), addShape(scene, {boxOf(size)}), {.position = at});
        scene.bodies.back().density = 10.0 * ratio;
        top += size.y;
    }
    return scene;
}

/// Boxes that overlap, in empty space without gravity, moving and spinning together.
BodyScene overlapping(Random& random) {
    BodyScene scene;
    for (int k = 0; k < 6; ++k) {
        const Vec3 at(0.7 * k, random.between(-0.2, 0.2), random.between(-0.2, 0.2));
        addFreeBody(scene, std::to_string(k), addShape(scene, {boxOf(sizeIn(random, 0.4, 1.2))}), {.position = at});
        scene.bodies.back().density = random.between(10.0, 1000.0);
        scene.bodies.back().velocity = {3.0, -2.0, random.between(-1.0, 1.0)};
        scene.bodies.back().angularVelocity = {1.0, random.between(-1.0, 1.0), 0.0};
    }
    return scene;
}

double massOf(const SceneWorld& made) {
    double sum = 0.0;
    for (const BodyId body : made.bodies)
        sum += made.world.kind(body) == BodyKind::Dynamic ? made.world.mass(body) : 0.0;
    return sum;
}

}  // namespace

class EnergyLimitTest : public QObject {
    Q_OBJECT
private slots:
    /// What sinks into a light body is not thrown back by it: lifted out of it, heavy bodies stay slow.
    void lightBodiesThrowNothingBack_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<int>("rate");
        for (const double ratio : {10.0, 100.0, 1000.0}) {
            for (const int rate : {30, 60, 120})
                QTest::addRow("%g : 1, %d steps a second", ratio, rate) << ratio << rate;
        }
    }
    void lightBodiesThrowNothingBack() {
        QFETCH(double, ratio);
        QFETCH(int, rate);
        Random random(static_cast<std::uint64_t>(ratio) + static_cast<std::uint64_t>(rate));
        for (int round = 0; round < 10; ++round) {
            SceneWorld made = worldOf(heavyOnLight(random, ratio, random.between(0.1, 2.0)), {.sleeping = false});
            const double rounding = 0.001 * massOf(made) * 9.81;  // contacts give way by so much
            const double peak = energyOf(made.world);
            double most = 0.0;
            for (int step = 0; step < rate; ++step) {
                const Momenta before = made.world.momenta();
                made.world.step(1.0 / rate);
                const Momenta after = made.world.momenta();
                const double fallen = std::max(0.0, before.potential - after.potential);
                most = std::max(most, after.kinetic - before.kinetic - fallen - rounding);
            }
            QVERIFY2(most < 0.002 * peak, QByteArray::number(100.0 * most / peak) + " %");
        }
    }
    /// Overlaps are resolved in the same direction on both sides, and what they would add is taken from relative
    /// motion.
    void islandsKeepTheirMomentum() {
        Random random(7);
        for (int round = 0; round < 20; ++round) {
            SceneWorld made = worldOf(overlapping(random), {.sleeping = false});
            QVERIFY(made.world.setGravity(Vec3(0.0)).hasValue());
            const Momenta start = made.world.momenta();
            double kinetic = start.kinetic;
            for (int step = 0; step < 30; ++step) {
                made.world.step(kStep);
                const double now = made.world.momenta().kinetic;
                QVERIFY(now <= kinetic * (1.0 + 1e-4));
                kinetic = now;
            }
            const Momenta end = made.world.momenta();
            const double scale = glm::length(start.linear);
            QVERIFY(glm::length(end.linear - start.linear) < 1e-4 * scale);
            // Rotation in contact keeps angular momentum only nearly (docs/adr/0014).
            QVERIFY2(glm::length(end.angular - start.angular) < 0.05 * glm::length(start.angular),
                     QByteArray::number(glm::length(end.angular - start.angular) / glm::length(start.angular)));
        }
    }
    /// A lift does work.
    void kinematicBodiesGiveEnergy() {
        BodyScene scene;
        const std::uint32_t plate = addShape(scene, {boxOf({4.0, 0.2, 4.0})});
        scene.bodies.push_back({.name = "lift", .kind = BodyKind::Kinematic, .shape = plate});
        scene.bodies.back().velocity = {0.0, 2.0, 0.0};
        addFreeBody(scene, "load", addShape(scene, {boxOf(Vec3(1.0))}), {.position = {0.0, 0.6, 0.0}});
        SceneWorld made = worldOf(scene);
        simulate(made.world, 2.0);
        QVERIFY(std::abs(made.world.state(made.bodies[1]).velocity.y - 2.0) < 0.01);
        QVERIFY(std::abs(made.world.state(made.bodies[1]).pose.position.y - 4.6) < 0.02);
    }
};

RUBBLE_TEST(EnergyLimitTest)
#include "EnergyLimitTest.moc"
