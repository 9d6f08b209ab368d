#include "core/play/scene/PlayMortar.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/MortarPortal.h"

using namespace rubble;

namespace {

const PlayStructure& structureOfInstance(const PlayScene& scene, std::size_t k) {
    return *scene.structures.at(scene.project.instances[k].id);
}

double mortarArea(const PlayStructure& structure) {
    double area = 0.0;
    for (std::uint32_t bond = structure.firstMortar(); bond < structure.graph.bondCount(); ++bond)
        area += structure.graph.bonds[bond].area;
    return area;
}

Vec3 inWorld(const Instance& instance, Vec3 point) {
    const Pose pose = poseOf(instance);
    return pose.position + pose.orientation * point;
}

}  // namespace

class PlayMortarTest : public QObject {
    Q_OBJECT
private slots:
    void commonFacesAreJoined() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        QVERIFY(scene->diagnostics.empty());
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 0)) - 1.0) < 1e-9);
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 1)) - 1.0) < 1e-9);
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 2)) - 2.0) < 1e-9);
        QVERIFY(structureOfInstance(*scene, 2).isHeld());
    }
    /// They take ever more time and memory: 12 s and 1.3 GB for 200 walls in one place.
    void mortarOfTooManyPairsIsRefused_data() {
        QTest::addColumn<int>("beams");
        QTest::addColumn<int>("mortars");
        QTest::newRow("instances in one place") << 200 << 1;
        QTest::newRow("mortars of all instances") << 30 << 600;
    }
    void mortarOfTooManyPairsIsRefused() {
        QFETCH(const int, beams);
        QFETCH(const int, mortars);
        Project project = test::mortarPortal();
        const Instance beam = project.instances[2];
        for (int k = 1; k < beams; ++k) {
            project.instances.push_back(beam);
            project.instances.back().id = project.nextId++;
            project.instances.back().name += std::to_string(k);
        }
        const Mortar mortar = project.mortars[0];
        for (int k = 1; k < mortars; ++k) {
            project.mortars.push_back(mortar);
            project.mortars.back().id = project.nextId++;
            project.mortars.back().name += std::to_string(k);
        }
        const auto scene = playScene(project);
        QVERIFY(!scene);
        QVERIFY2(scene.error().code == ErrorCode::Limit, scene.error().message.c_str());
        QVERIFY2(scene.error().message.starts_with("Mortar \"joints"), scene.error().message.c_str());
    }
    void jointsAreKnown() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        QCOMPARE(scene->mortars.size(), std::size_t{1});
        const JoinedMortar& mortar = scene->mortars[0];
        QCOMPARE(mortar.mortar, scene->project.mortars[0].id);
        QVERIFY(mortar.isHeld);
        double area = 0.0;
        for (const MortarJoint& joint : mortar.joints) {
            area += joint.area;
            QVERIFY(joint.first < joint.second);
            QCOMPARE(joint.second, scene->project.instances[2].id);  // the lintel on both piers
            QVERIFY(std::abs(std::abs(joint.normal.y) - 1.0) < 1e-9);
        }
        QVERIFY(std::abs(area - 2.0) < 1e-9);
    }
    void jointsOfWhatIsNotAnchoredAreNotHeld() {
        Project project = test::mortarPortal();
        for (Instance& instance : project.instances) instance.isAnchored = instance.isFixed = false;
        const auto scene = test::playSceneOf(project);
        QVERIFY(!scene->mortars[0].joints.empty());
        QVERIFY(!scene->mortars[0].isHeld);
        QCOMPARE(scene->diagnostics.size(), std::size_t{1});
    }
    void halvesLeadToEachOther() {
        Project project = test::mortarPortal();
        project.instances[2].pose.orientation = {0.0, 0.0, 1.0, 0.0};  // 180° about y
        const auto scene = test::playSceneOf(project);
        for (const auto& [id, structure] : scene->structures) {
            const Instance& instance = *findInstance(scene->project, id);
            for (std::uint32_t k = structure->firstMortar(); k < structure->graph.bondCount(); ++k) {
                const MortarLink& link = *structure->mortarOf(k);
                const PlayStructure& other = *scene->structures.at(link.instance);
                QCOMPARE(*other.mortarOf(link.bond), (MortarLink{id, k}));
                const Bond &here = structure->graph.bonds[k], &there = other.graph.bonds[link.bond];
                const Instance& neighbour = *findInstance(scene->project, link.instance);
                QCOMPARE(here.area, there.area);
                QCOMPARE(structure->capacities[k], 500.0 * here.area);
                QVERIFY(glm::distance(inWorld(instance, here.centroid), inWorld(neighbour, there.centroid)) < 1e-12);
                QVERIFY(glm::length(poseOf(instance).orientation * here.normal +
                                    poseOf(neighbour).orientation * there.normal) < 1e-12);
            }
        }
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 2)) - 2.0) < 1e-9);
    }
    void turnedInstancesHaveTheSameFaces() {
        Project project = test::mortarPortal();
        const double half = std::sqrt(0.5);
        for (int k = 0; k < 2; ++k) project.instances[k].pose.orientation = {half, 0.0, half, 0.0};  // 90° about y
        const auto scene = test::playSceneOf(project);
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 2)) - 2.0) < 1e-9);
    }
    void onlyNamedInstancesAreJoined() {
        Project project = test::mortarPortal();
        project.mortars[0].instances = {project.instances[0].id, project.instances[2].id};
        const auto scene = test::playSceneOf(project);
        QVERIFY(structureOfInstance(*scene, 1).mortar.empty());
        QVERIFY(std::abs(mortarArea(structureOfInstance(*scene, 2)) - 1.0) < 1e-9);
    }
    void tooSmallFacesAndWideJointsAreNot() {
        Project project = test::mortarPortal();
        project.mortars[0].leastArea = 1.5;
        QVERIFY(structureOfInstance(*test::playSceneOf(project), 2).mortar.empty());
        project.mortars[0].leastArea = 0.0;
        project.instances[2].pose.position.y += 0.02;
        QVERIFY(structureOfInstance(*test::playSceneOf(project), 2).mortar.empty());
        project.mortars[0].tolerance = 0.03;
        QVERIFY(!structureOfInstance(*test::playSceneOf(project), 2).mortar.empty());
    }
    void ofSeveralMortarsTheFirstCounts() {
        Project project = test::mortarPortal();
        project.mortars.push_back({.id = project.nextId++, .name = "again", .impulsePerArea = 1.0});
        const auto scene = test::playSceneOf(project);
        const PlayStructure& beam = structureOfInstance(*scene, 2);
        QVERIFY(std::abs(mortarArea(beam) - 2.0) < 1e-9);
        QCOMPARE(beam.capacities.back(), 500.0 * beam.graph.bonds.back().area);
    }
    void fixedNeighboursAreAnchors() {
        Project project = test::mortarPortal();
        for (int k = 0; k < 2; ++k) project.instances[k].isAnchored = false, project.instances[k].isFixed = true;
        project.assets[0].breakAs = BreakAs::Whole;
        const auto scene = test::playSceneOf(project);
        const PlayStructure& beam = *scene->structures.at(project.instances[2].id);
        QVERIFY(std::abs(mortarArea(beam) - 2.0) < 1e-9 && beam.isHeld());
        QVERIFY(beam.mortarOf(beam.firstMortar()) == nullptr);
    }
    void mortarWithoutAnchorsHoldsNothing() {
        Project project = test::mortarPortal();
        for (Instance& instance : project.instances) instance.isAnchored = false;
        const auto scene = test::playSceneOf(project);
        for (const auto& [id, structure] : scene->structures) QVERIFY(structure->mortar.empty());
        QCOMPARE(scene->diagnostics.size(), 1u);
        QCOMPARE(scene->diagnostics[0].code, DiagnosticCode::IdleMortar);
        QVERIFY(scene->diagnostics[0].message.find("joints") != std::string::npos);
    }
    void onlyWhatMortarConnectsIsJoined() {
        Project project = test::mortarPortal();
        for (int k = 0; k < 3; ++k) {
            Instance other = project.instances[k];
            other.id = project.nextId++;
            other.name += " again";
            other.pose.position.x += 10.0;
            project.instances.push_back(other);
        }
        const auto scene = test::playSceneOf(project);
        const auto joined = [&](std::set<Id> instances) { return joinedGroups(scene->structures, instances); };
        const auto id = [&](std::size_t k) { return project.instances[k].id; };
        QCOMPARE(joined({id(1), id(2)}).size(), std::size_t{1});
        QVERIFY((*joined({id(1)}).at(id(0)) == std::vector{id(0), id(1), id(2)}));
        QVERIFY((*joined({id(5)}).at(id(3)) == std::vector{id(3), id(4), id(5)}));
        QCOMPARE(joined({id(1), id(4)}).size(), std::size_t{2});
        QVERIFY(joined({}).empty() && joined({0}).empty());
    }
};

RUBBLE_TEST(PlayMortarTest)
#include "PlayMortarTest.moc"
