#include "core/physics/Lanes.h"
#include "tests/support/Simulated.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

using namespace rubble;

namespace {

std::string hashAfter(const BodyScene& scene, int threads, LaneWidth lanes) {
    SceneWorld moved = test::worldOf(scene, {.threads = threads, .lanes = lanes});
    test::simulate(moved.world, 2.0);
    return moved.world.hash().hex();
}

}  // namespace

/// The same bits always: on any number of threads, any width of lanes, any compiler.
class DeterminismTest : public QObject {
    Q_OBJECT
private slots:
    void hashesAreAsEver_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("expected");
        // Any change of the solver may change them; another compiler or machine must not.
        QTest::newRow("cut house") << "cut-house" << "";
        QTest::newRow("heap") << "heap-200" << "";
        QTest::newRow("house") << "house" << "";
    }
    void hashesAreAsEver() {
        QFETCH(QString, name);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(
                     hashAfter(test::sceneNamed(name.toStdString()), 1, widestLanes())),
                 expected);
    }
    void neitherThreadsNorLanesNorRunsMatter_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("cut house") << "cut-house";
        QTest::newRow("heap") << "heap-200";
    }
    void neitherThreadsNorLanesNorRunsMatter() {
        QFETCH(QString, name);
        const BodyScene scene = test::sceneNamed(name.toStdString());
        const std::string expected = hashAfter(scene, 1, widestLanes());
        for (int run = 0; run < 2; ++run) QCOMPARE(hashAfter(scene, 1, widestLanes()), expected);
        for (const int threads : {2, 3, 16}) QCOMPARE(hashAfter(scene, threads, widestLanes()), expected);
        for (const LaneWidth lanes : availableLanes()) QCOMPARE(hashAfter(scene, 1, lanes), expected);
    }
};

QTEST_APPLESS_MAIN(DeterminismTest)
#include "DeterminismTest.moc"
