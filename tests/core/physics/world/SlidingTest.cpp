// Tests core/physics/narrowphase/SeparatingAxis.cpp and core/physics/step/NarrowPhase.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SlidingScenes.h"

#include <QTest>

using namespace rubble;

Q_DECLARE_METATYPE(rubble::test::SlidingScene)

/// A body that slides over flush tiles is not stopped by their edges.
class SlidingTest : public QObject {
    Q_OBJECT
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
        SceneWorld moved = test::worldOf(sliding.scene);
        test::simulate(moved.world, 12.0);
        const Vec3 path =
            moved.world.state(moved.bodies.back()).pose.position - sliding.scene.bodies.back().pose.position;
        const double along = glm::dot(path, sliding.direction);
        const double aside = glm::length(path - along * sliding.direction);
        qInfo("%.3f of %.3f m, %.3f m aside", along, sliding.distance, aside);
        QVERIFY(along >= kLeast * sliding.distance);
        QVERIFY(along <= kMost * sliding.distance);
        QVERIFY(aside <= kAside * sliding.distance);
        QVERIFY(glm::length(moved.world.state(moved.bodies.back()).velocity) < 1e-3);
    }
};

RUBBLE_TEST(SlidingTest)
#include "SlidingTest.moc"
