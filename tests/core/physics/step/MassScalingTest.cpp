// Tests core/physics/step/MassScaling.cpp.
#include "core/physics/step/MassScaling.h"
#include "core/physics/step/Solver.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/ContactBlocks.h"
#include "tests/support/scenes/LoadedScenes.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

#include <array>

using namespace rubble;
using namespace rubble::test;

Q_DECLARE_METATYPE(rubble::test::LoadedScene)

namespace {

/// The inverse masses and inertias of all bodies.
std::vector<float> inertiasOf(const WorldState& state) {
    std::vector<float> values;
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        const SymMat3f& m = state.poses[k].inverseInertia;
        values.insert(values.end(), {state.motions[k].inverseMass, m.xx, m.xy, m.xz, m.yy, m.yz, m.zz});
    }
    return values;
}

double massInStep(const WorldState& state) {
    double sum = 0.0;
    for (const BodyMotion& motion : state.motions)
        sum += motion.inverseMass > 0.0f ? 1.0 / static_cast<double>(motion.inverseMass) : 0.0;
    return sum;
}

double massOf(const WorldState& state) {
    double sum = 0.0;
    for (const Body& body : state.bodies) sum += static_cast<double>(body.mass);
    return sum;
}

double sinkingOf(const BodyScene& scene, const SceneWorld& moved) {
    return scene.bodies.back().pose.position.y - moved.world.state(moved.bodies.back()).pose.position.y;
}

}  // namespace

class MassScalingTest : public QObject {
    Q_OBJECT
private slots:
    void lightBodiesCarryHeavyOnes_data() {
        QTest::addColumn<LoadedScene>("loaded");
        for (const LoadedScene& loaded : loadedScenes()) QTest::newRow(loaded.name.c_str()) << loaded;
    }
    void lightBodiesCarryHeavyOnes() {
        QFETCH(LoadedScene, loaded);
        // m: contacts are springs, and a stack sinks by the sum of those under it. Six plates of 2 cm sink most.
        constexpr double kMaxSinking = 0.025, kMaxAside = 0.01;
        SceneWorld moved = worldOf(loaded.scene);
        simulate(moved.world, 10.0);
        double aside = 0.0;
        for (std::size_t k = 0; k < moved.bodies.size(); ++k) {
            const Vec3 path = moved.world.state(moved.bodies[k]).pose.position - loaded.scene.bodies[k].pose.position;
            aside = std::max(aside, std::hypot(path.x, path.z));
        }
        const double sinking = sinkingOf(loaded.scene, moved);
        qInfo("sunk %.1f mm, %.1f mm aside", 1e3 * sinking, 1e3 * aside);
        QVERIFY(areAllAsleep(moved));
        QVERIFY(sinking <= kMaxSinking);
        QVERIFY(aside <= kMaxAside);
    }
    void heavyBodiesThatFallAreCarried_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("drop");
        for (const int count : {1, 3}) {
            for (const double drop : {0.01, 0.1, 1.0}) QTest::addRow("%d cubes, %.2f m", count, drop) << count << drop;
        }
    }
    void heavyBodiesThatFallAreCarried() {
        QFETCH(int, count);
        QFETCH(double, drop);
        BodyScene scene = loadedTower(count, 1000.0);
        scene.bodies.back().pose.position.y += drop;
        SceneWorld moved = worldOf(scene);
        simulate(moved.world, 10.0);
        QVERIFY(areAllAsleep(moved));
        QVERIFY(std::abs(sinkingOf(scene, moved) - drop) < 0.02);
    }
    /// The heavy body lends its mass: what slides on a light plate brakes as v² / (2 μ g) says.
    void loadsSlideAsFarAsFrictionLetsThem() {
        constexpr double kSpeed = 2.9, kFriction = 0.3;
        for (const double ratio : {30.0, 100.0, 1000.0}) {
            BodyScene scene = cubeOnPlates(1, ratio);
            scene.bodies[1].velocity = scene.bodies[2].velocity = {kSpeed, 0.0, 0.0};
            for (SceneBody& body : scene.bodies) body.friction = kFriction;
            SceneWorld moved = worldOf(scene);
            simulate(moved.world, 5.0);
            const double expected = kSpeed * kSpeed / (2.0 * kFriction * 9.81);
            const double path = moved.world.state(moved.bodies.back()).pose.position.x;
            qInfo("%g: %.3f of %.3f m", ratio, path, expected);
            QVERIFY(std::abs(path - expected) < 0.01 * expected);
        }
    }
    /// The limit: bodies of similar mass are not scaled, so that towers of masses that grow from one cube to the next
    /// stand up to about 100 : 1 in all, and sink.
    void massesThatGrowStepByStepAreCarriedUpToAHundred() {
        BodyScene scene;
        addGround(scene, 10.0);
        const std::uint32_t cube = addShape(scene, {boxOf(Vec3(1.0))});
        double density = 10.0;
        for (int k = 0; k < 5; ++k, density *= 3.0) {
            addFreeBody(scene, std::to_string(k), cube, {.position = {0.0, k + 0.5, 0.0}});
            scene.bodies.back().density = density;
        }
        SceneWorld moved = worldOf(scene);
        simulate(moved.world, 10.0);
        QVERIFY(areAllAsleep(moved));
        QVERIFY(sinkingOf(scene, moved) < 0.04);
    }
    void massesAreLentAndRestored() {
        SceneWorld made = worldOf(loadedTower(3, 1000.0));
        made.world.step(kStep);
        WorldState state = made.world.snapshot()->state;
        const std::vector<float> before = inertiasOf(state);
        const SolverStep step = solverStep(state, static_cast<float>(kStep));
        const std::vector<ScaledBody> scaled =
            scaleMasses(state, std::array{allBlocks(state)}, kernelsOf(widestSimd()), step);
        QCOMPARE(scaled.size(), 4u);
        for (std::size_t k = 0; k < 3; ++k) QVERIFY(std::abs(scaled[k].inverseScale - 0.01f) < 1e-6f);
        QVERIFY(std::abs(scaled[3].inverseScale - 1.0f / 0.703f) < 1e-5f);  // 3 · (10,000 - 100) kg of 10⁵ are lent
        QVERIFY(std::abs(massInStep(state) - massOf(state)) < 1e-5 * massOf(state));
        restoreMasses(state, scaled);
        QVERIFY(inertiasOf(state) == before);
    }
    /// The whole weight, and no more, rests on the ground.
    void weightsStay() {
        SceneWorld made = worldOf(loadedTower(3, 1000.0), {.sleeping = false});
        simulate(made.world, 10.0);
        double impulse = 0.0;
        for (const ContactPoint& point : made.world.contactPoints()) {
            if (point.first == made.bodies[0]) impulse += point.impulse;
        }
        const double weight = 9.81 * (1e5 + 300.0);
        qInfo("%.1f of %.1f N", 240.0 * impulse, weight);
        QVERIFY(std::abs(240.0 * impulse - weight) < 1e-3 * weight);
    }
    void hashesDoNotDependOnThreadsAndLanes() {
        const BodyScene scene = slabOnPebbles(24, 1000.0);  // more contacts than are solved on one thread
        const auto hashOf = [&](const WorldSettings& settings) {
            SceneWorld moved = worldOf(scene, settings);
            simulate(moved.world, 0.5);
            return moved.world.hash();
        };
        const ContentHash expected = hashOf({.threads = 1, .lanes = SimdWidth::Scalar});
        for (const SimdWidth width : availableSimdWidths()) {
            for (const int threads : {1, 2, 4}) {
                QVERIFY(hashOf({.threads = threads, .lanes = width}) == expected);
            }
        }
    }
};

RUBBLE_TEST(MassScalingTest)
#include "MassScalingTest.moc"
