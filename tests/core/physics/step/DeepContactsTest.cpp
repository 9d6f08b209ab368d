// Tests core/physics/step/DeepContacts.cpp.
#include "core/physics/step/DeepContacts.h"

#include "core/physics/islands/Sleeping.h"
#include "core/physics/step/Solver.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The displacements along y of a box and one that lies `depth` deep in it, after a step that moved nothing.
std::vector<float> displacementsOf(double depth, BodyKind below, double speed = 0.0) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t shape = addShape(scene, {boxOf({0.5, 0.1, 0.5})});
    scene.bodies.push_back({.name = "below", .kind = below, .shape = shape});
    scene.bodies.push_back({.name = "above",
                            .pose = {.position = {0.0, 0.1 - depth, 0.0}},
                            .velocity = {0.0, -speed, 0.0},
                            .shape = shape});
    SceneWorld moved = worldOf(scene);
    moved.world.collide(kStep);
    WorldState state = moved.world.snapshot()->state;
    updateAwakeBodies(state);
    ThreadPool threads(1);
    Regions regions;
    regions.assignBodies(state, 1);
    regions.sortContacts(state, threads);
    SolveScratch scratch;
    const SolverStep step = solverStep(state, static_cast<float>(kStep));
    prepareContacts(state, threads, regions, scratch, kernelsOf(SimdWidth::Scalar), step);
    displaceDeepContacts(state, scratch.deepBlocks, step.dt);
    return {state.motions[1].deltaPosition.y, state.motions[2].deltaPosition.y};
}

}  // namespace

class DeepContactsTest : public QObject {
    Q_OBJECT
private slots:
    /// Beyond a third of the width of the thinner, a fifth of the excess in a step of 1/60 s.
    void bothGiveWay() {
        const std::vector<float> ways = displacementsOf(0.036, BodyKind::Dynamic);
        QVERIFY(std::abs(ways[1] - 0.5f * 0.2f * 0.004f) < 1e-5f);
        QVERIFY(std::abs(ways[0] + ways[1]) < 1e-7f);
    }
    void whatIsFixedDoesNot() {
        const std::vector<float> ways = displacementsOf(0.036, BodyKind::Static);
        QCOMPARE(ways[0], 0.0f);
        QVERIFY(std::abs(ways[1] - 0.2f * 0.004f) < 1e-5f);
    }
    void slowly() { QVERIFY(std::abs(displacementsOf(0.05, BodyKind::Static)[1] - 0.1f / 60.0f) < 1e-5f); }
    void softContactsAndImpactsAreLeft() {
        QCOMPARE(displacementsOf(0.03, BodyKind::Dynamic)[1], 0.0f);
        QCOMPARE(displacementsOf(0.036, BodyKind::Dynamic, 1.0)[1], 0.0f);
    }
};

RUBBLE_TEST(DeepContactsTest)
#include "DeepContactsTest.moc"
