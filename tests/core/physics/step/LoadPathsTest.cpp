// Tests core/physics/step/LoadPaths.cpp.
#include "core/physics/step/LoadPaths.h"
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

namespace {

/// What the bodies of a scene carry in the second step.
std::vector<Load> loadsOf(const BodyScene& scene) {
    SceneWorld made = worldOf(scene);
    made.world.step(kStep);
    WorldState state = made.world.snapshot()->state;
    return findLoads(state, std::array{allBlocks(state)}, solverStep(state, static_cast<float>(kStep)));
}

/// A body of 1000 kg beside, above or below one of 1 kg.
BodyScene twoCubes(Vec3 heavy, Vec3 light) {
    BodyScene scene;
    addGround(scene, 10.0);
    const std::uint32_t cube = addShape(scene, {boxOf(Vec3(1.0))});
    addFreeBody(scene, "light", cube, {.position = light});
    addFreeBody(scene, "heavy", cube, {.position = heavy});
    scene.bodies[1].density = 1.0;
    return scene;
}

}  // namespace

class LoadPathsTest : public QObject {
    Q_OBJECT
private slots:
    void eachCubeOfATowerCarriesTheHeavyOne() {
        const std::vector<Load> loads = loadsOf(loadedTower(3, 1000.0));
        QCOMPARE(loads.size(), 3u);
        for (const Load& load : loads) {
            QVERIFY(std::abs(load.mass - 1e5f) < 1.0f);
            QCOMPARE(load.source, 5u);  // bodies are counted from 1, which is the ground
        }
        QCOMPARE(loads.front().body, 2u);
    }
    void eachStoneCarriesAQuarterOfTheSlab() {
        const std::vector<Load> loads = loadsOf(slabOnStones(1000.0));
        QCOMPARE(loads.size(), 4u);
        for (const Load& load : loads) QVERIFY(std::abs(load.mass - 675.0f) < 0.01f);  // 1000 · 2.7 / 4
    }
    /// The cube on the top of a pyramid is carried by 1, 2, 3, 4 and 5 blocks a row; those outside carry less.
    void loadsSpreadDownwards() {
        const std::vector<Load> loads = loadsOf(loadedPyramid(1000.0));
        QCOMPARE(loads.size(), 15u);
        QVERIFY(std::abs(loads.back().mass - 25000.0f) < 1.0f);
        QVERIFY(loads.front().mass < 0.1f * loads.back().mass);
    }
    void bodiesOfSimilarMassCarryNothing() { QVERIFY(loadsOf(loadedTower(3, 8.0)).empty()); }
    void whatIsBesideOrOnAHeavyBodyCarriesNothing() {
        QVERIFY(loadsOf(twoCubes({0.0, 0.5, 0.0}, {1.0, 0.5, 0.0})).empty());
        QVERIFY(loadsOf(twoCubes({0.0, 0.5, 0.0}, {0.0, 1.5, 0.0})).empty());
        QCOMPARE(loadsOf(twoCubes({0.0, 1.5, 0.0}, {0.0, 0.5, 0.0})).size(), 1u);
    }
    void bodiesThatFallCarryNothing() {
        QVERIFY(loadsOf(twoCubes({0.0, 3.5, 0.0}, {0.0, 2.5, 0.0})).empty());
        BodyScene tower = loadedTower(4, 1000.0);
        for (SceneBody& body : tower.bodies) body.pose.position.y += body.kind == BodyKind::Dynamic ? 2.0 : 0.0;
        QVERIFY(loadsOf(tower).empty());
    }
    /// A light cube between two heavy ones, of which the lower carries no more than itself.
    void whatFallsOnAHeavyBodyCarriesNothing() {
        const auto loadsAt = [](double height) {
            BodyScene scene = twoCubes({0.0, 2.5 + height, 0.0}, {0.0, 1.5 + height, 0.0});
            addFreeBody(scene, "lower", 1, {.position = {0.0, 0.5 + height, 0.0}});
            return loadsOf(scene).size();
        };
        QCOMPARE(loadsAt(0.0), 1u);
        QCOMPARE(loadsAt(2.0), 0u);
    }
    void withoutGravityNothingIsCarried() {
        BodyScene scene = loadedTower(2, 1000.0);
        scene.gravity = Vec3(0.0);
        QVERIFY(loadsOf(scene).empty());
    }
    /// A heavy cube that leaves at 5 m/s, or passes, is not carried; one that falls onto a light cube is.
    void whatPassesIsNotCarried() {
        const auto loadsAt = [](Vec3 velocity) {
            BodyScene scene = twoCubes({0.0, 1.5, 0.0}, {0.0, 0.5, 0.0});
            scene.bodies.back().velocity = velocity;
            return loadsOf(scene).size();
        };
        QCOMPARE(loadsAt({0.0, 5.0, 0.0}), 0u);
        QCOMPARE(loadsAt({5.0, 0.0, 0.0}), 0u);
        QCOMPARE(loadsAt({0.0, -5.0, 0.0}), 1u);
        QCOMPARE(loadsAt({1.0, 0.0, 0.0}), 1u);
    }
};

RUBBLE_TEST(LoadPathsTest)
#include "LoadPathsTest.moc"
