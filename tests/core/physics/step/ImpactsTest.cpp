#include "core/physics/step/Impacts.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A cube of 1 m and 1000 kg over the ground, after collide(). Its bottom is at `height`.
SceneWorld cubeOver(double height, Vec3 velocity, double restitution = 0.0, Quat orientation = {1.0, 0.0, 0.0, 0.0}) {
    BodyScene scene;
    addGround(scene, 5.0);
    addFreeBody(scene, "cube", addShape(scene, {boxOf(Vec3(1.0))}),
                {.position = {1.0, 0.5 + height, 0.0}, .orientation = orientation});
    scene.bodies[1].velocity = velocity;
    scene.bodies[1].restitution = restitution;
    return worldOf(scene);
}

std::vector<Impact> impactsOf(SceneWorld& made) {
    made.world.collide(kStep);
    return made.world.impacts();
}

}  // namespace

class ImpactsTest : public QObject {
    Q_OBJECT
private slots:
    /// It falls 4 mm further, which makes it faster: v² = 4² + 2 · 9.81 · 0.004.
    void fallingCubeHitsTheGround() {
        SceneWorld made = cubeOver(0.004, {0.0, -4.0, 0.0});
        const std::vector<Impact> impacts = impactsOf(made);
        QCOMPARE(impacts.size(), std::size_t{1});
        const Impact& impact = impacts[0];
        QVERIFY(impact.first == made.bodies[0] && impact.second == made.bodies[1]);
        QVERIFY(std::abs(impact.approachSpeed - std::sqrt(16.07848)) < 1e-4);
        QVERIFY(std::abs(impact.effectiveMass - 1000.0) < 0.01);  // under its centre
        QVERIFY(glm::distance(impact.normal, Vec3(0.0, 1.0, 0.0)) < 1e-6);
        QVERIFY(glm::distance(impact.point, Vec3(1.0, 0.002, 0.0)) < 1e-4);
        QCOMPARE(impact.restitution, 0.0);
        QVERIFY(std::abs(impact.impulse() - 1000.0 * std::sqrt(16.07848)) < 0.1);
    }
    /// Apart by more than 5 mm, the cube is swept to where it touches: on the ground, not halfway.
    void distantCubeIsSweptToTheGround() {
        SceneWorld made = cubeOver(0.05, {0.0, -4.0, 0.0});
        const std::vector<Impact> impacts = impactsOf(made);
        QCOMPARE(impacts.size(), std::size_t{1});
        QVERIFY(std::abs(impacts[0].approachSpeed - std::sqrt(16.0 + 2.0 * 9.81 * 0.05)) < 1e-3);
        QVERIFY(std::abs(impacts[0].point.y) < 1e-3);
    }
    void cubeThatDoesNotArriveHitsNothing() {
        SceneWorld made = cubeOver(0.08, {0.0, -4.0, 0.0});  // 67 mm in the step
        QVERIFY(impactsOf(made).empty());
    }
    void slowContactsAreNoImpacts() {
        SceneWorld slow = cubeOver(0.0, {0.0, -0.45, 0.0}), away = cubeOver(0.0, {0.0, 4.0, 0.0}),
                   along = cubeOver(0.0, {4.0, 0.0, 0.0}), fast = cubeOver(0.0, {0.0, -0.55, 0.0});
        QVERIFY(impactsOf(slow).empty());
        QVERIFY(impactsOf(away).empty());
        QVERIFY(impactsOf(along).empty());
        QCOMPARE(impactsOf(fast).size(), std::size_t{1});
    }
    void restitutionNeedsTheRestitutionSpeed() {
        SceneWorld fast = cubeOver(0.0, {0.0, -1.1, 0.0}, 0.5), slow = cubeOver(0.0, {0.0, -0.9, 0.0}, 0.5);
        QCOMPARE(impactsOf(fast)[0].restitution, 0.5);
        QCOMPARE(impactsOf(slow)[0].restitution, 0.0);
        QVERIFY(std::abs(impactsOf(fast)[0].impulse() - 1.5 * 1.1 * 1000.0) < 0.5);
    }
    /// On its edge, the impact is the edge's: only the points at most 5 mm behind the first count. At the arm of half a
    /// metre the cube is lighter: 1 / (1/m + 0.5² / (m/6)) = m / 2.5.
    void impactIsAtTheFirstPoints() {
        const double angle = 0.1;  // the other edge is 0.1 m higher
        const double low = 0.5 * (std::cos(angle) + std::sin(angle)) - 0.5;
        SceneWorld made =
            cubeOver(low, {0.0, -4.0, 0.0}, 0.0, {std::cos(angle / 2.0), 0.0, 0.0, std::sin(angle / 2.0)});
        const std::vector<Impact> impacts = impactsOf(made);
        QCOMPARE(impacts.size(), std::size_t{1});
        const double arm = 0.5 * (std::cos(angle) - std::sin(angle));
        QVERIFY(std::abs(impacts[0].point.x - (1.0 - arm)) < 1e-3);
        QVERIFY(std::abs(impacts[0].effectiveMass - 1000.0 / (1.0 + 6.0 * arm * arm)) < 1.0);
    }
    /// Two events: the faster of two cubes is no earlier in the list, which is in the order of the bodies.
    void impactsAreSortedByBodies() {
        BodyScene scene;
        addGround(scene, 5.0);
        const std::uint32_t shape = addShape(scene, {boxOf(Vec3(1.0))});
        for (int k = 0; k < 3; ++k) {
            addFreeBody(scene, std::to_string(k), shape, {.position = {1.5 * k, 0.5, 0.0}});
            scene.bodies.back().velocity = {0.0, -2.0 - (k == 1 ? 5.0 : 0.0), 0.0};
        }
        SceneWorld made = worldOf(scene);
        const std::vector<Impact> impacts = impactsOf(made);
        QCOMPARE(impacts.size(), std::size_t{3});
        for (std::size_t k = 0; k < 3; ++k) QVERIFY(impacts[k].second == made.bodies[k + 1]);
    }
    void hitsOfTheStep() {
        SceneWorld made = cubeOver(0.0, {0.0, -4.0, 0.0}), slow = cubeOver(0.0, {0.0, -0.2, 0.0});
        made.world.step(kStep);
        const auto& hits = made.world.events().hits;
        QCOMPARE(hits.size(), std::size_t{1});
        QVERIFY(std::abs(hits[0].approachSpeed - 4.0) < 1e-4);
        QVERIFY(std::abs(hits[0].impulse - 1000.0 * (4.0 + 9.81 * kStep)) < 5.0);
        QVERIFY(glm::distance(hits[0].normal, Vec3(0.0, 1.0, 0.0)) < 1e-6);
        slow.world.step(kStep);
        QVERIFY(slow.world.events().hits.empty());
    }
    void contactPointsOfARestingCube() {
        SceneWorld made = cubeOver(0.0, Vec3(0.0));
        made.world.step(kStep);
        QCOMPARE(made.world.counts().contacts, 1);
        QCOMPARE(made.world.counts().contactPoints, 4);
        simulate(made.world, 2.0);
        QVERIFY(areAllAsleep(made));
        const std::vector<ContactPoint> points = made.world.contactPoints();  // stored while it sleeps
        QCOMPARE(points.size(), std::size_t{4});
        double impulse = 0.0;
        for (const ContactPoint& point : points) {
            QVERIFY(std::abs(std::abs(point.point.x - 1.0) - 0.5) < 1e-3 && std::abs(point.point.y) < 1e-3);
            impulse += point.impulse;
        }
        QVERIFY(std::abs(impulse - 9810.0 / 240.0) < 0.5);  // its weight, of a sub-step
    }
};

RUBBLE_TEST(ImpactsTest)
#include "ImpactsTest.moc"
