#include "core/play/session/Aim.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/Sessions.h"

#include <array>
#include <random>
#include <set>

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

/// The eye of the editor's first view of the house, m.
constexpr Vec3 kFirstEye{10.83, 13.67, 10.83};
/// Points of its walls that are visible from there, on the front (z = 3) and on the right (x = 2.5).
constexpr std::array kWallPoints{Vec3(1.0, 1.5, 3.0), Vec3(2.0, 2.5, 3.0), Vec3(-1.0, 1.5, 3.0), Vec3(-2.0, 2.5, 3.0),
                                 Vec3(2.5, 1.5, 0.0), Vec3(2.5, 2.5, 1.0), Vec3(2.5, 1.5, -1.0), Vec3(2.5, 2.5, -1.0)};

/// The area of a wall around a point through which one looks from the first eye, in cells of 15 cm.
std::set<std::pair<int, int>> openCells(const Session& session, Vec3 middle) {
    constexpr double kCell = 0.15, kBehind = 0.7;  // m; walls are 0.5 m thick
    const Vec3 across = middle.z == 3.0 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 0.0, 1.0), up(0.0, 1.0, 0.0);
    std::set<std::pair<int, int>> open;
    for (int i = -8; i <= 8; ++i) {
        for (int j = -8; j <= 8; ++j) {
            const Vec3 point = middle + kCell * (static_cast<double>(i) * across + static_cast<double>(j) * up);
            const Ray ray{kFirstEye, glm::normalize(point - kFirstEye)};
            const std::optional<CastHit> hit = firstHit(session.world(), ray);
            const double wall = glm::distance(kFirstEye, point);
            if (!hit || glm::distance(kFirstEye, hit->point) > wall + kBehind) open.emplace(i, j);
        }
    }
    return open;
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
        const std::optional<Blast> blast = blastAlong(session, {.impulse = 5.0, .radius = 3.0}, ray);
        QVERIFY(blast && blast->radius == 3.0);
        QVERIFY(glm::distance(blast->at, blow->at + Vec3(0.0, 0.0, 0.3)) < 1e-5);
        QVERIFY(!hammerAlong(session, 7.0, past) && !blastAlong(session, {}, past));
    }
    void blastGoesOffInTheMiddleOfAGap() {
        Project project = test::floatingBlock();
        test::addInstance(project, project.assets[0].id, "opposite", {.position = {0.0, 5.0, 0.7}});  // gap of 0.2 m
        const Ray down{{0.1, 9.0, 0.35}, {0.0, -1.0, 0.0}}, across{{0.1, 5.0, 0.3}, {0.0, 0.0, -1.0}};
        const Session session = test::sessionOf(project);
        const std::optional<Blast> narrow = blastAlong(session, {.radius = 3.0}, across);
        QVERIFY(narrow && glm::distance(narrow->at, Vec3(0.1, 5.0, 0.35)) < 1e-5);
        const std::optional<Blast> wide = blastAlong(session, {.radius = 0.5}, across);
        QVERIFY(wide && glm::distance(wide->at, Vec3(0.1, 5.0, 0.3)) < 1e-5);
        const std::optional<Blast> ground = blastAlong(session, {.radius = 2.0}, down);
        QVERIFY(ground && glm::distance(ground->at, Vec3(0.1, 0.2, 0.35)) < 1e-4);
    }
    void reachesTheTargetInFourTenthsOfASecond() {
        const Session session = test::sessionOf(test::floatingBlock());
        const Ray far{{0.1, 5.1, 16.25}, {0.0, 0.0, -1.0}}, past{{5.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};
        QVERIFY(std::abs(reachingSpeed(session, {.mass = 200.0}, far) - 40.0) < 1e-4);  // 16 m
        QCOMPARE(reachingSpeed(session, {.mass = 200.0}, past), 75.0);                  // 30 m, hitting nothing
    }
    /// The block of 500 kg breaks at 100 N·s.
    void lightProjectilesAreFastEnoughToBreakTheTarget() {
        const Session session = test::sessionOf(test::floatingBlock());
        const Ray ray{{0.0, 5.0, 1.25}, {0.0, 0.0, -1.0}};
        QVERIFY(std::abs(reachingSpeed(session, {.mass = 1000.0}, ray) - 2.5) < 1e-4);
        QVERIFY(std::abs(reachingSpeed(session, {.mass = 10.0}, ray) - 300.0 * (1.0 / 10.0 + 1.0 / 500.0)) < 1e-3);
        QCOMPARE(reachingSpeed(session, {.mass = 0.001}, ray), 100.0);
        Project fixed = test::floatingBlock();
        fixed.instances[0].isFixed = true;
        QVERIFY(std::abs(reachingSpeed(test::sessionOf(fixed), {.mass = 10.0}, ray) - 30.0) < 1e-3);
    }
    /// The projectile that the editor throws if nothing else is set. A tap of 22 m/s and 200 kg cracked blocks into
    /// hairlines.
    void aTapOpensAHoleInTheHouse() {
        Session session = test::sessionOf(test::house());
        const std::shared_ptr<const SessionSnapshot> start = session.snapshot();
        for (const Vec3 point : kWallPoints) {
            session.restore(*start);
            const std::set<std::pair<int, int>> before = openCells(session, point);
            const Ray ray{kFirstEye, glm::normalize(point - kFirstEye)};
            Throw thrown{.size = Vec3(0.7), .mass = 2500.0};
            thrown.speed = reachingSpeed(session, thrown, ray);
            test::addInput(session, ShotInput{"throw", throwAlong(session, thrown, ray)});
            for (int step = 0; step < 120; ++step) session.step();
            std::set<std::pair<int, int>> opened = openCells(session, point);
            std::erase_if(opened, [&](const auto& cell) { return before.contains(cell); });
            qInfo("(%g, %g, %g) at %.1f m/s: %.2f m2", point.x, point.y, point.z, thrown.speed,
                  0.0225 * static_cast<double>(opened.size()));
            QVERIFY(opened.size() >= 8);  // 0.18 m²
        }
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
