// Tests core/physics/narrowphase/SeparatingAxis.cpp, core/physics/step/NarrowPhase.cpp and
// core/physics/solver/FrictionKernels.h.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SlidingScenes.h"

#include <QTest>

using namespace rubble;

Q_DECLARE_METATYPE(rubble::test::SlidingScene)

/// A body that slides over flush tiles is not stopped by their edges, and friction does not turn it aside.
class SlidingTest : public QObject {
    Q_OBJECT

    /// How far a body came along its first direction and aside of it, m, and how fast it is at the end, m/s.
    struct Path {
        double along = 0.0, aside = 0.0, speed = 0.0;
    };
    static Path pathOf(const test::SlidingScene& sliding, double seconds) {
        SceneWorld moved = test::worldOf(sliding.scene);
        test::simulate(moved.world, seconds);
        const BodyState end = moved.world.state(moved.bodies.back());
        const Vec3 path = end.pose.position - sliding.scene.bodies.back().pose.position;
        const double along = glm::dot(path, sliding.direction);
        return {along, glm::length(path - along * sliding.direction), glm::length(end.velocity)};
    }

private slots:
    void bodySlidesAsFarAsFrictionLetsIt_data() {
        QTest::addColumn<test::SlidingScene>("sliding");
        for (const test::SlidingScene& scene : test::slidingScenes()) QTest::newRow(scene.name.c_str()) << scene;
    }
    void bodySlidesAsFarAsFrictionLetsIt() {
        QFETCH(test::SlidingScene, sliding);
        constexpr double kLeast = 0.9;  // of the distance: a contact at an edge may brake the body a little
        constexpr double kMost = 1.04;  // a contact that begins at a seam takes over its load within a step
        constexpr double kAside = 0.1;
        const Path path = pathOf(sliding, 12.0);
        qInfo("%.3f of %.3f m, %.3f m aside", path.along, sliding.distance, path.aside);
        QVERIFY(path.along >= kLeast * sliding.distance);
        QVERIFY(path.along <= kMost * sliding.distance);
        QVERIFY(path.aside <= kAside * sliding.distance);
        QVERIFY(path.speed < 1e-3);
    }
    void frictionActsAgainstTheMotion() {
        constexpr double kTolerance = 0.01;  // of the distance: of velocities before and after a sub-step
        constexpr double kAside = 0.0087;    // half a degree
        double shortest = 1.0, longest = 1.0, farthest = 0.0;
        for (const test::SlidingScene& sliding : test::obliqueSlidingScenes()) {
            const Path path = pathOf(sliding, 2.0);
            shortest = std::min(shortest, path.along / sliding.distance);
            longest = std::max(longest, path.along / sliding.distance);
            farthest = std::max(farthest, path.aside / sliding.distance);
            QVERIFY2(std::abs(path.along - sliding.distance) <= kTolerance * sliding.distance, sliding.name.c_str());
            QVERIFY2(path.aside <= kAside * sliding.distance, sliding.name.c_str());
            QVERIFY2(path.speed < 1e-3, sliding.name.c_str());
        }
        qInfo("%.4f to %.4f of the distance, %.5f of it aside", shortest, longest, farthest);
    }
};

RUBBLE_TEST(SlidingTest)
#include "SlidingTest.moc"
