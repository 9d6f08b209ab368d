// Tests core/physics/step/Solver.cpp and core/physics/islands/Sleeping.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

using namespace rubble;

/// Stability of stacks and heaps.
class StandingTest : public QObject {
    Q_OBJECT
private slots:
    void stacksStandForTenSeconds_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("most");
        // m: what a scene settles by. A wall of ten courses sinks by the sum of ten contacts, a pyramid by twenty.
        QTest::newRow("house") << "house" << 0.005;
        QTest::newRow("wall") << "wall" << 0.016;
        QTest::newRow("pyramid") << "pyramid" << 0.030;
    }
    void stacksStandForTenSeconds() {
        QFETCH(QString, name);
        QFETCH(double, most);
        const BodyScene scene = test::sceneNamed(name.toStdString());
        for (const bool isSleeping : {false, true}) {
            SceneWorld moved = test::worldOf(scene, {.sleeping = isSleeping});
            test::simulate(moved.world, 10.0);
            const double farthest = test::farthestMoved(scene, moved);
            qInfo("%s: %.2f mm", isSleeping ? "asleep" : "awake", 1e3 * farthest);
            QVERIFY(farthest <= most);
            QCOMPARE(test::areAllAsleep(moved), isSleeping);
        }
    }
    void heapsDoNotPenetrate() {
        const BodyScene scene = test::heapScene(test::isLongRun() ? 3350 : 600);
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        test::simulate(moved.world, 7.0);
        const Penetration penetration = penetrationOf(scene, test::posesOf(moved));
        qInfo("largest %.1f mm, mean %.2f mm", 1e3 * penetration.largest, 1e3 * penetration.mean);
        QVERIFY(penetration.pairs > 0);
        QVERIFY(penetration.largest <= 0.035);
        QVERIFY(penetration.mean <= 0.003);
    }
};

RUBBLE_TEST(StandingTest)
#include "StandingTest.moc"
