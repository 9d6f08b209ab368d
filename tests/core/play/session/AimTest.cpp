#include "core/play/session/Aim.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/Sessions.h"

#include <random>

using namespace rubble;

namespace {

constexpr Vec3 kGravity{0.0, -9.81, 0.0};

/// How near a flight comes to a point, m.
double nearest(const Throw& thrown, Vec3 point, Vec3 gravity) {
    const Vec3 way = thrown.to - thrown.from;
    const Vec3 velocity = thrown.speed / std::sqrt(glm::dot(way, way)) * way;
    double least = 1e9;
    for (double time = 0.0; time < 5.0; time += 1e-4) {
        const Vec3 apart = thrown.from + time * velocity + 0.5 * time * time * gravity - point;
        least = std::min(least, std::sqrt(glm::dot(apart, apart)));
    }
    return least;
}

}  // namespace

class AimTest : public QObject {
    Q_OBJECT
private slots:
    void trajectoryPassesThroughTheTarget() {
        std::mt19937 random(11);
        qInfo("seed 11");
        std::uniform_real_distribution<double> place(-8.0, 8.0);
        for (int k = 0; k < 40; ++k) {
            const Vec3 target(place(random), place(random), place(random));
            const Throw thrown = aimedAt({.from = {0.0, 2.0, 12.0}, .speed = 25.0}, target, kGravity);
            QVERIFY(nearest(thrown, target, kGravity) < 0.01);
        }
    }
    void lowerArcIsUsed() {
        const Throw thrown = aimedAt({.from = Vec3(0.0), .speed = 20.0}, {10.0, 0.0, 0.0}, kGravity);
        QVERIFY(thrown.to.y > 0.0 && thrown.to.y < 2.0);
    }
    void withoutGravityTheAimIsStraight() {
        const Vec3 target(1.0, 2.0, 3.0);
        QCOMPARE(aimedAt({.speed = 5.0}, target, Vec3(0.0)).to, target);
    }
    void unreachableTargetIsAimedAtDirectly() {
        const Vec3 target(100.0, 0.0, 0.0);
        QCOMPARE(aimedAt({.from = Vec3(0.0), .speed = 5.0}, target, kGravity).to, target);
        QCOMPARE(aimedAt({.from = Vec3(0.0), .speed = 5.0}, {0.0, 50.0, 0.0}, kGravity).to, Vec3(0.0, 50.0, 0.0));
    }
    void trajectoryEndsAtTheFirstHit() {
        const Session session = test::sessionOf(test::floatingBlock());
        const Trajectory flight = trajectoryOf(session, test::throwAtBlock(1.0, 10.0), 3.0);
        QVERIFY(flight.hit.has_value());
        QVERIFY(std::abs(flight.hit->point.z - 0.25) < 1e-5);  // its front face
        QCOMPARE(flight.points.back(), flight.hit->point);
        QCOMPARE(flight.points.size(), 6u);  // 0.75 m at 1/6 m a step
        Throw past = test::throwAtBlock(1.0, 10.0);
        past.to = {5.0, 5.0, 0.5};
        QVERIFY(!trajectoryOf(session, past, 0.5).hit);
        QCOMPARE(trajectoryOf(session, past, 0.5).points.size(), 31u);
    }
    void rayAimsAtItsFirstHit() {
        const Session session = test::sessionOf(test::floatingBlock());
        const Ray ray{{0.1, 5.1, 4.0}, {0.0, 0.0, -1.0}}, past{{5.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};
        const Throw thrown = throwAlong(session, {.speed = 3.0}, ray);
        QCOMPARE(thrown.from, ray.from);
        QVERIFY(std::abs(thrown.to.z - 0.25) < 1e-5);
        QCOMPARE(throwAlong(session, {.speed = 3.0}, past).to, past.at(30.0));
        const std::optional<Hammer> blow = hammerAlong(session, 7.0, ray);
        QVERIFY(blow && std::abs(blow->at.z - 0.25) < 1e-5);
        QCOMPARE(blow->impulse, Vec3(0.0, 0.0, -7.0));
        const std::optional<Explosion> blast = explosionAlong(session, {.impulse = 5.0, .radius = 3.0}, ray);
        QVERIFY(blast && blast->at == blow->at && blast->radius == 3.0);
        QVERIFY(!hammerAlong(session, 7.0, past) && !explosionAlong(session, {}, past));
    }
    void trajectoryMatchesTheSimulation() {
        Project project = test::floatingBlock();
        project.gravity = kGravity;
        Session session = test::sessionOf(project);
        const Throw thrown = aimedAt({.size = Vec3(0.2), .mass = 2.0, .from = {3.0, 1.0, 9.0}, .speed = 12.0},
                                     {3.0, 1.0, 0.0}, kGravity);
        const Trajectory flight = trajectoryOf(session, thrown, 0.5);
        test::addInput(session, ShotInput{"throw", thrown});
        for (int step = 0; step < 30; ++step) session.step();
        const Vec3 apart = session.world().state(session.bodies().back().body).centre - flight.points[30];
        QVERIFY(std::sqrt(glm::dot(apart, apart)) < 0.02);
    }
};

RUBBLE_TEST_WITH(AimTest, QCoreApplication)
#include "AimTest.moc"
