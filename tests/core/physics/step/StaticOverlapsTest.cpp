// Tests core/physics/step/StaticOverlaps.cpp, and what the step has for it: BroadPhase.cpp's findUnforeseenPairs().
#include "core/geometry/hull/HullOverlap.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

#include <array>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr double kMaxDepth = 0.005;  // m

/// A thin or thick, long or short box that spins, thrown at a floor.
BodyScene spinningBox(Random& random, double floorWidth) {
    BodyScene scene;
    addFixedBox(scene, "floor", {-floorWidth, -0.3, -floorWidth}, {floorWidth, 0.0, floorWidth});
    const Vec3 size{random.between(0.02, 2.0), random.between(0.02, 0.5), random.between(0.02, 0.5)};
    const auto component = [&](double most) { return random.between(-most, most); };
    const double spin = random.between(0.0, 60.0);
    scene.bodies.push_back(
        {.name = "box",
         .pose = {.position = {0.0, 0.6 * glm::length(size), 0.0}, .orientation = randomRotation(random)},
         .velocity = {component(5.0), -random.between(0.0, 20.0), component(5.0)},
         .angularVelocity = {component(spin), component(spin), component(spin)},
         .shape = addShape(scene, {boxOf(size)})});
    return scene;
}

/// How deep the last body of a scene is in any that is fixed, m.
double depthOf(const BodyScene& scene, const SceneWorld& moved) {
    double deepest = 0.0;
    const auto hullOf = [&](std::size_t body) -> const Polytope& {
        return scene.shapes[scene.bodies[body].shape].front();
    };
    const std::size_t last = scene.bodies.size() - 1;
    for (std::size_t k = 0; k < last; ++k) {
        if (scene.bodies[k].kind == BodyKind::Dynamic) continue;
        deepest = std::max(deepest, hullOverlap(hullOf(last), moved.world.state(moved.bodies[last]).pose, hullOf(k),
                                                moved.world.state(moved.bodies[k]).pose)
                                        .depth);
    }
    return deepest;
}

}  // namespace

class StaticOverlapsTest : public QObject {
    Q_OBJECT
private slots:
    /// Before, half of them went down by a fraction of a metre in the step of the impact.
    void whatSpinsStaysAboveTheFloor() {
        constexpr std::array kSteps{1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0};
        for (std::uint64_t seed = 1; seed <= 150; ++seed) {
            Random random(seed);
            const BodyScene scene = spinningBox(random, 20.0);
            const double dt = kSteps[seed % kSteps.size()];
            SceneWorld moved = worldOf(scene);
            double before = energyOf(moved.world);
            const double most = moved.world.momenta().kinetic + 9.81 * moved.world.mass(moved.bodies.back());
            for (double time = 0.0; time < 1.5; time += dt) {
                moved.world.step(dt);
                const double depth = depthOf(scene, moved), after = energyOf(moved.world);
                if (depth > kMaxDepth || after - before > 0.01 * most)
                    qWarning("seed %d at %.3f s: %.1f mm deep, %.3f %% of energy gained", static_cast<int>(seed), time,
                             1e3 * depth, 100.0 * (after - before) / most);
                QVERIFY(depth <= kMaxDepth);
                QVERIFY(after - before <= 0.01 * most);
                before = after;
            }
        }
    }
    /// A splinter between two fixed plates has no way out: it moves less.
    void whatIsWedgedMovesLess() {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            Random random(seed);
            BodyScene scene;
            addFixedBox(scene, "below", {-1.0, -0.1, -1.0}, {1.0, 0.0, 1.0});
            addFixedBox(scene, "above", {-1.0, 0.03, -1.0}, {1.0, 0.13, 1.0});
            const auto spin = [&] { return random.between(-100.0, 100.0); };
            scene.bodies.push_back({.name = "splinter",
                                    .pose = {.position = {0.0, 0.015, 0.0}},
                                    .velocity = {random.between(-10.0, 10.0), random.between(-10.0, 10.0), 0.0},
                                    .angularVelocity = {spin(), spin(), spin()},
                                    .shape = addShape(scene, {boxOf({0.3, 0.02, 0.04})})});
            SceneWorld moved = worldOf(scene);
            for (int step = 0; step < 40; ++step) {
                moved.world.step(1.0 / 60.0);
                QVERIFY2(depthOf(scene, moved) <= kMaxDepth, qPrintable(QString::number(seed)));
            }
        }
    }
    /// A cube beside a plate is far from it in all that it does by itself, until a ball of a tonne hits it.
    void whatIsPushedOutOfItsBoxStops() {
        for (const double speed : {50.0, 200.0, 500.0}) {
            BodyScene scene;
            scene.gravity = Vec3(0.0);
            addFixedBox(scene, "plate", {1.0, -3.0, -3.0}, {1.02, 3.0, 3.0});
            scene.bodies.push_back({.name = "ram",
                                    .density = 20000.0,
                                    .pose = {.position = {-1.05, 0.0, 0.0}},
                                    .velocity = {speed, 0.0, 0.0},
                                    .shape = addShape(scene, {boxOf(Vec3(1.0))})});
            scene.bodies.push_back(
                {.name = "cube", .pose = {.position = {-0.4, 0.0, 0.0}}, .shape = addShape(scene, {boxOf(Vec3(0.1))})});
            SceneWorld moved = worldOf(scene);
            for (int step = 0; step < 10; ++step) {
                moved.world.step(1.0 / 60.0);
                const double x = moved.world.state(moved.bodies.back()).pose.position.x;
                QVERIFY2(x < 1.0, qPrintable(QString::number(x)));
                if (x > 0.9) break;  // between both it has nowhere to go
            }
        }
    }
    /// What begins deep in something comes out about as fast as contacts push.
    void whatBeginsDeepComesOut() {
        BodyScene scene;
        addFixedBox(scene, "floor", {-5.0, -2.0, -5.0}, {5.0, 0.0, 5.0});
        addFreeBody(scene, "box", addShape(scene, {boxOf(Vec3(0.5))}), {.position = {0.0, 0.0, 0.0}});
        SceneWorld moved = worldOf(scene);
        double before = 0.0;
        for (int step = 0; step < 180; ++step) {
            moved.world.step(1.0 / 60.0);
            const double y = moved.world.state(moved.bodies.back()).pose.position.y;
            QVERIFY2(y - before <= 4.0 / 60.0, qPrintable(QString::number(60.0 * (y - before))));
            before = y;
        }
        QVERIFY(std::abs(before - 0.25) < 0.005);
    }
};

RUBBLE_TEST(StaticOverlapsTest)
#include "StaticOverlapsTest.moc"
