// Tests core/play/scene/HangingLoads.cpp.
#include "core/play/scene/HangingLoads.h"

#include "core/asset/strength/Threshold.h"
#include "core/play/scene/SupportProblems.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/MortarPortal.h"

using namespace rubble;

namespace {

constexpr double kCubeWeight = 2000.0 * 9.81;  // N: of 1 m³

/// Seeds beside each other, so that no fragment stands on another one.
PlacedSeeds sideBySide(std::uint64_t seed, double half) {
    Random random(seed);
    PlacedSeeds placed;
    for (std::uint32_t k = 0; k < 5; ++k) placed.seeds.push_back({k, {random.between(-half, half), 0.0}});
    return placed;
}

/// Cubes of 1 m in a row that are joined by mortar, in the air; the first is fixed. A row goes sideways, or upward.
Project row(std::uint32_t cubes, double impulsePerArea, std::uint64_t seed, bool isUpward = false) {
    Project project;
    const Id stone = test::addMaterial(project, {.name = "stone", .density = 2000.0});
    const Id cube = test::addAsset(
        project, {.name = "cube", .material = stone, .shape = Prism{{rectangle({-0.5, -0.5}, {0.5, 0.5}), {}}, 1.0}},
        {sideBySide(seed, 0.5)});
    const Id wall = test::addAsset(
        project, {.name = "wall", .material = stone, .shape = Prism{{rectangle({-0.5, -0.5}, {0.5, 0.5}), {}}, 1.0}},
        {UniformScatter{.count = 2}});
    project.assets[0].breakAs = BreakAs::Bonded;
    project.assets[0].bonding.impulsePerArea = 1e4;
    for (std::uint32_t k = 0; k < cubes; ++k)
        test::addInstance(project, k == 0 ? wall : cube, "cube " + std::to_string(k),
                          {.position = isUpward ? Vec3(0.0, k + 2.0, 0.0) : Vec3(k, 2.0, 0.0)});
    project.instances[0].isFixed = true;
    project.mortars = {{.id = project.nextId++, .name = "joints", .impulsePerArea = impulsePerArea}};
    return project;
}

struct Sum {
    double load = 0.0, strength = 0.0;
};
/// Of what hangs on the mortar of an instance.
Sum onMortarOf(std::span<const HangingLoad> loads, Id instance) {
    Sum sum;
    for (const HangingLoad& one : loads) {
        if (one.instance != instance) continue;
        sum.load += one.mortar * one.load;
        sum.strength += one.mortar > 0.999 ? one.strength : 0.0;
    }
    return sum;
}

bool hasWeakBonds(const Project& project) {
    const std::vector<Diagnostic> problems = supportProblems(*test::playSceneOf(project));
    return std::ranges::find(problems, DiagnosticCode::WeakBonds, &Diagnostic::code) != problems.end();
}

}  // namespace

class HangingLoadsTest : public QObject {
    Q_OBJECT
private slots:
    /// A row that sticks out of a wall hangs on its first joint with all of its weight, on the second with all but the
    /// first cube, and so on.
    void aRowHangsOnItsJoints() {
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            const Project project = row(4, 500.0, seed);
            const std::vector<HangingLoad> loads = hangingLoads(*test::playSceneOf(project));
            for (std::uint32_t k = 1; k < 4; ++k) {
                const Sum sum = onMortarOf(loads, project.instances[k].id);
                QVERIFY2(isNear(sum.load, (4 - k) * kCubeWeight, 1e-4), QByteArray::number(seed));
                QVERIFY2(sum.strength <= 500.0 / kDefaultContactTime * (1.0 + 1e-6), QByteArray::number(seed));
            }
        }
    }
    /// Mortar under what stands need not hold anything.
    void whatStandsHangsOnNothing() {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const Project project = row(4, 1e-9, seed, true);
            const std::vector<HangingLoad> loads = hangingLoads(*test::playSceneOf(project));
            for (const Instance& instance : project.instances) QCOMPARE(onMortarOf(loads, instance.id).load, 0.0);
            QVERIFY(!hasWeakBonds(project));
        }
    }
    void mortarThatTakesLessThanHangsOnItIsReported() {
        // 3 cubes of 19.6 kN hang on 1 m²: 58.9 N·s/m² in 1 ms
        QVERIFY(hasWeakBonds(row(4, 20.0, 1)));
        QVERIFY(!hasWeakBonds(row(4, 1000.0, 1)));
        Project weightless = row(4, 20.0, 1);
        weightless.gravity = Vec3(0.0);
        QVERIFY(hangingLoads(*test::playSceneOf(weightless)).empty() && !hasWeakBonds(weightless));
        const std::vector<Diagnostic> problems = supportProblems(*test::playSceneOf(row(4, 1e-9, 1)));
        QCOMPARE(problems.size(), std::size_t{3});
        QVERIFY2(problems[0].message.find(" on mortar that takes ") != std::string::npos, problems[0].message.c_str());
        QVERIFY(problems[0].value > 1000.0 && problems[0].limit < 1.0 && isOfSupport(problems[0]));
    }
    /// A storey on mortar of next to nothing.
    void aBeamHangsBetweenItsPiers() {
        Project project = test::mortarPortal(1e-9);
        project.assets[1].pattern.layers[0].parameters = sideBySide(1, 1.0);
        QVERIFY(!hasWeakBonds(project));  // it stands on the piers
        project.instances[2].pose.position = {0.0, 2.0, 0.0};
        project.assets[1].prism().outline = {rectangle({-1.0, -0.5}, {1.0, 0.5}), {}};  // between them
        QVERIFY(hasWeakBonds(project));
        const std::vector<HangingLoad> loads = hangingLoads(*test::playSceneOf(project));
        QVERIFY(isNear(onMortarOf(loads, project.instances[2].id).load, 2.0 * kCubeWeight, 1e-4));
        project.mortars[0].impulsePerArea = 500.0;
        QVERIFY(!hasWeakBonds(project));
    }
    void bondsOfAnAssetAreLookedAt() {
        Project project = test::bondedPortal(0.0, 0.0);  // of 1e4 N·s/m²
        QVERIFY(!hasWeakBonds(project));
        project.assets[0].bonding.impulsePerArea = 1.0;
        QVERIFY(hasWeakBonds(project));
        project.instances[0].isAnchored = false;  // it falls as one
        QVERIFY(!hasWeakBonds(project));
    }
};

RUBBLE_TEST(HangingLoadsTest)
#include "HangingLoadsTest.moc"
