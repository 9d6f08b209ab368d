// Tests core/physics/world/World.cpp and core/physics/world/WorldHash.cpp.
#include "core/physics/math/Lanes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr double kSeconds = 2.0;

std::string hashAfter(double seconds, const BodyScene& scene, int threads = 1, SimdWidth lanes = widestSimd()) {
    SceneWorld moved = test::worldOf(scene, {.threads = threads, .lanes = lanes});
    test::simulate(moved.world, seconds);
    return moved.world.hash().hex();
}

}  // namespace

/// Hashes are identical for any number of threads, SIMD width and compiler.
class DeterminismTest : public QObject {
    Q_OBJECT
private slots:
    void hashesAreFixed_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("expected");
        // Any change of the solver, or for the cut house of the fracture, may change them; another compiler or machine
        // must not.
        QTest::newRow("cut house") << "cut-house"
                                   << "af00773b4f2bd8f6ab26a81492d136f9";
        QTest::newRow("heap") << "heap-200"
                              << "91829ccfe341b0dc7fea5b877fba6b61";
        QTest::newRow("house") << "house"
                               << "82fdd4f675cb26e822c5e7ce2ad43766";
    }
    void hashesAreFixed() {
        QFETCH(QString, name);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(hashAfter(kSeconds, test::sceneNamed(name.toStdString()))), expected);
    }
    void hashIsIndependentOfThreadsLanesAndRuns_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("cut house") << "cut-house";
        QTest::newRow("heap") << "heap-200";
    }
    void hashIsIndependentOfThreadsLanesAndRuns() {
        QFETCH(QString, name);
        const BodyScene scene = test::sceneNamed(name.toStdString());
        const std::string expected = hashAfter(kSeconds, scene);
        for (int run = 0; run < 2; ++run) QCOMPARE(hashAfter(kSeconds, scene), expected);
        for (const int threads : {2, 3}) QCOMPARE(hashAfter(kSeconds, scene, threads), expected);
        for (const SimdWidth lanes : availableSimdWidths()) QCOMPARE(hashAfter(kSeconds, scene, 1, lanes), expected);
        // More threads than processors wait for each other.
        const double few = test::isLongRun() ? kSeconds : 0.5;
        QCOMPARE(hashAfter(few, scene, 16), hashAfter(few, scene));
    }
    /// Pieces that fly are swept against what stands; those of a burst are enough for several threads from the start.
    void burstsAreIndependentOfThreads() {
        constexpr double kFlight = 0.25;  // s
        const BodyScene scene = test::sceneNamed("burst-4700-4");
        const std::string expected = hashAfter(kFlight, scene);
        for (const int threads : {2, 3}) QCOMPARE(hashAfter(kFlight, scene, threads), expected);
    }
};

RUBBLE_TEST(DeterminismTest)
#include "DeterminismTest.moc"
