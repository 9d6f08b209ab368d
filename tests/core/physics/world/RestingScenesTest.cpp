// Tests core/physics/step/Solver.cpp, core/physics/narrowphase/Manifold.cpp and core/physics/islands/Sleeping.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/RestingScenes.h"

#include <QTest>

using namespace rubble;

Q_DECLARE_METATYPE(rubble::test::RestingLimits)

namespace {

constexpr double kMaxPenetrationFraction = 0.5;  // of the thinnest side
constexpr double kGround = -1.0;                 // m: the bottom of the ground

/// How far a body has moved sideways at most, m.
double driftOf(const BodyScene& scene, const std::vector<Pose>& poses) {
    double drift = 0.0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const Vec3 moved = poses[k].position - scene.bodies[k].pose.position;
        drift = std::max(drift, std::hypot(moved.x, moved.z));
    }
    return drift;
}

std::ptrdiff_t awakeCount(const SceneWorld& moved) {
    return std::ranges::count_if(moved.bodies, [&](BodyId body) {
        return moved.world.kind(body) == BodyKind::Dynamic && !moved.world.state(body).asleep;
    });
}

void addRows(std::span<const test::RestingScene> scenes) {
    QTest::addColumn<BodyScene>("scene");
    QTest::addColumn<test::RestingLimits>("limits");
    const std::uint64_t randomSeeds = test::isLongRun() ? 5 : 1;
    for (const test::RestingScene& scene : scenes) {
        for (std::uint64_t randomSeed = 1; randomSeed <= randomSeeds; ++randomSeed) {
            QTest::addRow("%s, random seed %d", scene.name, static_cast<int>(randomSeed))
                << scene.build(randomSeed) << scene.limits;
        }
    }
}

}  // namespace

/// Stacks of bodies of several hulls and piles of slender bodies come to rest.
class RestingScenesTest : public QObject {
    Q_OBJECT

    /// Simulates a scene and checks what must hold of all scenes. Returns the drift, m.
    static double simulated(const BodyScene& scene, const test::RestingLimits& limits) {
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, limits.seconds);
        const std::vector<Pose> poses = test::posesOf(moved);
        const double penetration = penetrationOf(scene, poses).largest;
        const double most = std::min(limits.penetration, kMaxPenetrationFraction * test::thinnestSide(scene));
        const double drift = driftOf(scene, poses);
        const std::ptrdiff_t awake = awakeCount(moved);
        qInfo("%td awake, penetration %.1f of at most %.1f mm, drift %.1f mm", awake, 1e3 * penetration, 1e3 * most,
              1e3 * drift);
        verify(awake == 0, "asleep");
        verify(penetration <= most, "penetration");
        verify(std::ranges::all_of(poses, [](const Pose& pose) { return pose.position.y > kGround; }), "on the ground");
        return drift;
    }
    static void verify(bool isTrue, const char* what) { QVERIFY2(isTrue, what); }

private slots:
    void stacksStand_data() { addRows(test::stackScenes()); }
    void stacksStand() {
        QFETCH(BodyScene, scene);
        QFETCH(test::RestingLimits, limits);
        QVERIFY(simulated(scene, limits) <= limits.drift);
    }
    void pilesComeToRest_data() { addRows(test::pileScenes()); }
    void pilesComeToRest() {
        QFETCH(BodyScene, scene);
        QFETCH(test::RestingLimits, limits);
        simulated(scene, limits);
    }
};

RUBBLE_TEST(RestingScenesTest)
#include "RestingScenesTest.moc"
