// Tests core/physics/state/AngularMomentum.cpp and core/physics/step/Solver.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/RotatingScenes.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr int kSteps = 300;

/// The energies of a scene, relative to that at the start.
struct EnergyRange {
    double least = 1.0;
    double most = 1.0;
    double largestRise = 0.0;  // in a step
};

EnergyRange energiesOf(const BodyScene& scene, double dt) {
    SceneWorld moved = test::worldOf(scene, {.sleeping = false});
    const double start = test::energyOf(moved.world);
    EnergyRange range;
    double before = 1.0;
    for (int step = 0; step < kSteps; ++step) {
        moved.world.step(dt);
        const double now = test::energyOf(moved.world) / start;
        if (!std::isfinite(now)) return {.least = now, .most = now, .largestRise = now};
        range = {std::min(range.least, now), std::max(range.most, now), std::max(range.largestRise, now - before)};
        before = now;
    }
    return range;
}

// Of the energy at the start.
constexpr double kMaxGain = 0.01;
constexpr double kMaxLoss = 0.03;

bool isConserved(const EnergyRange& range) { return range.least >= 1.0 - kMaxLoss && range.most <= 1.0 + kMaxGain; }

}  // namespace

/// The energy of slender bodies with large angular velocities.
class RotationTest : public QObject {
    Q_OBJECT
private slots:
    void freeRodsConserveEnergy_data() {
        QTest::addColumn<double>("aspect");
        QTest::addColumn<Vec3>("axis");
        const std::vector<std::pair<const char*, Vec3>> axes{{"across", {0.0, 0.0, 1.0}},
                                                             {"nearly across", {0.99, 0.14, 0.0}},
                                                             {"askew", {0.7, 0.7, 0.14}},
                                                             {"nearly along", {0.1, 0.99, 0.0}}};
        for (const int aspect : {20, 40, 60, 100}) {
            for (const auto& [name, axis] : axes) {
                QTest::addRow("1 : %d, %s", aspect, name) << double(aspect) << glm::normalize(axis);
            }
        }
    }
    /// By 0.1 to 2 rad per step, at 30 to 240 Hz.
    void freeRodsConserveEnergy() {
        QFETCH(double, aspect);
        QFETCH(Vec3, axis);
        for (const double rate : {0.1, 0.25, 0.5, 1.0, 1.5, 2.0}) {
            for (const int hertz : {30, 60, 120, 240}) {
                const EnergyRange range = energiesOf(test::freeRod(aspect, axis, rate, 1.0 / hertz), 1.0 / hertz);
                QVERIFY2(isConserved(range), qPrintable(QString("%1 rad per step at %2 Hz: energy %3 to %4")
                                                            .arg(rate)
                                                            .arg(hertz)
                                                            .arg(range.least)
                                                            .arg(range.most)));
            }
        }
    }
    void freeSolidsConserveEnergy() {
        const std::uint64_t count = test::isLongRun() ? 5000 : 1000;
        EnergyRange worst;
        for (std::uint64_t randomSeed = 1; randomSeed <= count; ++randomSeed) {
            const double dt = 1.0 / (30 << (randomSeed % 4));
            const EnergyRange range = energiesOf(test::freeSolid(randomSeed, dt), dt);
            QVERIFY2(isConserved(range),
                     qPrintable(
                         QString("random seed %1: energy %2 to %3").arg(randomSeed).arg(range.least).arg(range.most)));
            worst = {std::min(worst.least, range.least), std::max(worst.most, range.most)};
        }
        qInfo("energy %.4f to %.4f", worst.least, worst.most);
    }
    /// A few may gain a little: the impulses of a step act on arms as they are at its beginning.
    void hittingTheGroundDoesNotAddEnergy() {
        constexpr double kMaxGainOfFew = 0.05;
        constexpr double kFew = 0.004;
        const std::uint64_t count = test::isLongRun() ? 5000 : 500;
        double most = 0.0;
        std::uint64_t gaining = 0;
        for (std::uint64_t randomSeed = 1; randomSeed <= count; ++randomSeed) {
            const EnergyRange range = energiesOf(test::rotatingOntoGround(randomSeed, test::kStep), test::kStep);
            const double gain = std::max(range.most - 1.0, range.largestRise);
            if (!(gain <= kMaxGain)) ++gaining;
            if (!(gain <= most)) most = gain;
        }
        qInfo("%d of %d gain more than 1 %%, the worst %.3g %%", int(gaining), int(count), 100.0 * most);
        QVERIFY(static_cast<double>(gaining) <= kFew * static_cast<double>(count));
        QVERIFY(most <= kMaxGainOfFew);
    }
};

RUBBLE_TEST(RotationTest)
#include "RotationTest.moc"
