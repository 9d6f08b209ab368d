// Tests core/play/scene/PlayStructure.cpp and core/play/scene/PlayBodyShape.cpp.
#include "core/play/scene/PlayStructure.h"

#include "core/play/scene/PlayBodyShape.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <cmath>

using namespace rubble;

namespace {

double anchoredArea(const PlayStructure& structure) {
    double area = 0.0;
    for (const Bond& bond : structure.graph.bonds) area += bond.second == kNone ? bond.area : 0.0;
    return area;
}

const PlayStructure& onlyStructure(const PlayScene& scene) { return *scene.structures.begin()->second; }

}  // namespace

class PlayStructureTest : public QObject {
    Q_OBJECT
private slots:
    void anchoredWallStandsOnItsFoot() {
        const auto scene = test::playSceneOf(test::bondedWall());
        const PlayStructure& structure = onlyStructure(*scene);
        QVERIFY(structure.isHeld() && !structure.holdsHeaviest);
        QVERIFY(std::abs(anchoredArea(structure) - 4.0 * 0.25) < 1e-9);
        for (std::size_t k = 0; k < structure.graph.bonds.size(); ++k) {
            const Bond& bond = structure.graph.bonds[k];
            QVERIFY(std::abs(structure.capacities[k] - 100.0 * bond.area) < 1e-9);
            if (bond.second != kNone) continue;
            QVERIFY(std::abs(bond.centroid.y + 1.5) < 1e-9);
            QVERIFY(bond.normal.y < -0.999);
        }
    }
    void bondsOfClustersHaveLevels() {
        const auto plain = test::playSceneOf(test::bondedWall(40));
        QVERIFY(onlyStructure(*plain).clusterLevels.empty());
        const auto scene = test::playSceneOf(test::clusteredWall(40, 3));
        const PlayStructure& structure = onlyStructure(*scene);
        std::size_t anchors = 0;
        for (const Bond& bond : structure.graph.bonds) anchors += bond.second == kNone ? 1 : 0;
        QVERIFY(anchors > 3);
        QCOMPARE(structure.clusterLevels.size() + anchors, structure.graph.bonds.size());
        for (ClusterLevel level = 0; level < 3; ++level)
            QVERIFY(std::ranges::count(structure.clusterLevels, level) > 0);
        for (std::size_t k = structure.clusterLevels.size(); k < structure.graph.bonds.size(); ++k)
            QVERIFY(structure.graph.bonds[k].second == kNone);
    }
    void freeWallHasNoAnchors() {
        Project project = test::bondedWall();
        project.instances[0].isAnchored = false;
        QVERIFY(!onlyStructure(*test::playSceneOf(project)).isHeld());
        project.instances[0].isAnchored = true;
        project.instances[0].pose.position.y = 2.0;
        QVERIFY(!onlyStructure(*test::playSceneOf(project)).isHeld());
    }
    void rotatedWallIsAnchoredToAFixedBlock() {
        Project project = test::bondedWall(50);
        const Id block = test::addAsset(project,
                                        {.name = "block",
                                         .material = project.materials[0].id,
                                         .shape = Prism{{rectangle({-3.0, -0.5}, {3.0, 0.5}), {}}, 6.0}},
                                        {UniformScatter{.count = 3}});
        test::addInstance(project, block, "block", {.position = {0.0, 0.5, 0.0}});
        project.instances.back().isFixed = true;
        project.instances[0].pose = {{0.0, 2.5, 0.0}, glm::angleAxis(0.7, Vec3(0.0, 1.0, 0.0))};
        const auto scene = test::playSceneOf(project);
        QVERIFY(std::abs(anchoredArea(onlyStructure(*scene)) - 1.0) < 1e-9);
        QCOMPARE(fixedSolids(scene->project, scene->assets).size(), std::size_t{2});  // and the ground
    }
    void fixedWallInTheAirHoldsItsHeaviestIsland() {
        Project project = test::bondedWall(20);
        project.instances[0].isAnchored = false;
        project.instances[0].isFixed = true;
        QVERIFY(!onlyStructure(*test::playSceneOf(project)).holdsHeaviest);  // it stands on the ground
        project.instances[0].pose.position.y = 5.0;
        QVERIFY(onlyStructure(*test::playSceneOf(project)).holdsHeaviest);
    }
    void paintedAnchorsNeverBreak() {
        Project project = test::bondedWall(20);
        project.instances[0].isAnchored = false;
        project.assets[0].bonding.strokes = {{.brush = BondBrush::Anchor, .radius = 0.05, .points = {{-2.0, 1.5}}}};
        const auto scene = test::playSceneOf(project);
        const PlayStructure& structure = onlyStructure(*scene);
        QVERIFY(structure.isHeld());
        QVERIFY(std::isinf(structure.capacities.back()));
        QVERIFY(!scene->assetStructures.begin()->second.at(kNone)->isHeld());  // thrown, it is not held
    }
    void strongerInstancesHoldMore() {
        Project project = test::bondedWall(20);
        project.instances[0].bondStrength = 3.0;
        const auto scene = test::playSceneOf(project);
        const PlayStructure& own = onlyStructure(*scene);
        const PlayStructure& asset = *scene->assetStructures.begin()->second.at(kNone);
        QVERIFY(std::abs(own.capacities[0] - 3.0 * asset.capacities[0]) < 1e-12);
        QVERIFY(strengthened(asset, 2.0)->leastImpulse == 2.0 * asset.leastImpulse);
        QVERIFY(structureIn(*scene, {.instance = project.instances[0].id}, kNone).get() == &own);
    }
    void shapesOfPartsAreCompounds() {
        const auto scene = test::playSceneOf(test::bondedWall(20));
        PlayBody body{.asset = scene->assets.begin()->second, .nodes = {2, 5}};
        const std::shared_ptr<const Shape> shape = shapeOf(body);
        const double volume = body.asset->fragments[2].shape->mass.volume + body.asset->fragments[5].shape->mass.volume;
        QVERIFY(std::abs(shape->mass.volume - volume) < 1e-12);
        QVERIFY(shape->hulls[0].hull == body.asset->fragments[2].shape->hulls[0].hull);
        body.isHeld = true;
        QVERIFY(shapeOf(body)->mass.centre == body.asset->whole.shape->mass.centre);
        body.nodes.clear();
        QVERIFY(shapeOf(body) == body.asset->whole.shape);
    }
    void bondsWithoutStrengthAreBrokenFromTheStart() {
        Project project = test::bondedWall(20);
        const auto scene = test::playSceneOf(project);
        const PlayStructure& wall = *scene->structures.begin()->second;
        QCOMPARE(std::ranges::count(wall.initialDamage, kBroken), std::ptrdiff_t{0});
        QVERIFY(wall.isHeld() && !scene->hasUnjoined);
        const auto weak = strengthened(wall, 0.0);
        QCOMPARE(std::ranges::count(weak->initialDamage, kBroken), std::ptrdiff_t{weak->graph.bondCount()});
        QVERIFY(!weak->isHeld());
        QCOMPARE(weak->leastImpulse, std::numeric_limits<double>::infinity());
        QVERIFY(strengthened(wall, 1e-9)->isHeld());
    }
};

RUBBLE_TEST(PlayStructureTest)
#include "PlayStructureTest.moc"
