// Tests how core/play/breaking/BondBreaking.cpp and core/play/breaking/BrokenBonds.cpp break clusters.
#include "core/play/queries/WouldFall.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <algorithm>

using namespace rubble;

namespace {

Session thrownAt(const Project& project, const ShotAction& action, int steps, const SessionSettings& settings = {}) {
    Session session = test::sessionOf(project, settings);
    test::addInput(session, ShotInput{"throw", action});
    for (int k = 0; k < steps; ++k) session.step();
    return session;
}

/// The clusters of the fragments of the wall at each level.
std::vector<std::vector<std::uint32_t>> clustersOf(const Session& session) {
    const Asset& asset = session.scene().project.assets[0];
    return clustersOfFragments(asset, *test::onlyAsset(session.scene()).bake, 0);
}

/// Whether the bodies that came off, but for single fragments, have all or none of each cluster of a level.
bool areClustersWhole(const Session& session, std::size_t level) {
    const std::vector<std::uint32_t> clusters = clustersOf(session)[level];
    for (const PlayBody& body : session.bodies()) {
        if (body.bondedFracture() == nullptr) continue;
        for (const std::uint32_t node : body.nodes) {
            if (clusters[node] == kNone) continue;
            for (std::uint32_t other = 0; other < clusters.size(); ++other) {
                if (clusters[other] == clusters[node] && !std::ranges::binary_search(body.nodes, other)) return false;
            }
        }
    }
    return true;
}

std::size_t bodiesOfFragments(const Session& session) {
    return static_cast<std::size_t>(std::ranges::count_if(
        session.bodies(), [](const PlayBody& body) { return body.isDebris() || body.role == PlayRole::Instance; }));
}

/// The number of bonds of a level, and how many of them broke.
std::pair<std::size_t, std::size_t> bondsOfLevel(const Session& session, ClusterLevel level) {
    const PlayStructure& structure = *session.scene().structures.begin()->second;
    const InstanceDamage damage = session.damage().begin()->second;
    std::pair<std::size_t, std::size_t> counts;
    for (std::size_t bond = 0; bond < structure.clusterLevels.size(); ++bond) {
        if (structure.clusterLevels[bond] != level) continue;
        ++counts.first;
        counts.second += damage.broken[bond] ? 1 : 0;
    }
    return counts;
}

}  // namespace

class ClusterBreakingTest : public QObject {
    Q_OBJECT
private slots:
    void wallLosesAWholeCluster() {
        Session session = test::sessionOf(test::clusteredWall());
        test::addInput(session, ShotInput{"ball", test::ballAtWall()});
        while (session.events().splits.empty() && session.stepsDone() < 60) session.step();
        QVERIFY(!session.events().splits.empty());
        QVERIFY(areClustersWhole(session, 0));
        QVERIFY(bondsOfLevel(session, 0).second > 3);
        QCOMPARE(bondsOfLevel(session, 1).second + bondsOfLevel(session, 2).second, std::size_t{0});
        QVERIFY(test::wallOf(session).isHeld && test::wallOf(session).nodes.size() < 300);
        for (const PlayBody& body : session.bodies()) QVERIFY(!body.isDebris() || body.nodes.size() > 10);
    }
    /// A hit anywhere in a cluster breaks it off, also in its middle, where only its own bonds are within the radius.
    void hammerBreaksOffTheClusterThatItHits() {
        Project project = test::clusteredWall();
        project.assets[0].bonding.radius = 0.01;
        const Bake baked = *bake(project.assets[0]);
        int tried = 0;
        for (std::uint32_t node = 0; node < baked.fragmentCount(); node += 7) {
            const Vec3 centre = baked.fragment(node).solid.offset() + project.instances[0].pose.position;
            const Vec3 at{centre.x, centre.y, 0.125};
            const Session session = thrownAt(project, Hammer{.at = at, .impulse = {0.0, 0.0, -2000.0}}, 1);
            const std::vector<std::uint32_t> clusters = clustersOf(session)[0];
            if (test::wallOf(session).nodes.size() == 300) continue;  // it is anchored
            std::vector<std::uint32_t> expected;
            for (std::uint32_t k = 0; k < clusters.size(); ++k) {
                if (clusters[k] == clusters[node]) expected.push_back(k);
            }
            const auto isIt = [&](const PlayBody& body) { return body.nodes == expected; };
            QVERIFY2(std::ranges::any_of(session.bodies(), isIt), QByteArray::number(node));
            ++tried;
        }
        QVERIFY2(tried > 20, QByteArray::number(tried));
    }
    void levelsBreakOneAfterTheOther() {
        Project project = test::clusteredWall(200, 6);
        project.instances[0].isAnchored = false;
        Session session = test::sessionOf(project);
        std::size_t before = 1;
        for (ClusterLevel level = 0; level < 3; ++level) {
            for (const PlayBody& body : session.bodies()) {
                if (body.bondedFracture() != nullptr) test::addInput(session, BreakInput{body.number});
            }
            session.step();
            const auto [bonds, broken] = bondsOfLevel(session, level);
            QVERIFY(bonds > 10);
            QCOMPARE(broken, bonds);
            for (ClusterLevel deeper = level + 1; deeper < 3; ++deeper)
                QCOMPARE(bondsOfLevel(session, deeper).second, 0u);
            QVERIFY(bodiesOfFragments(session) > before);
            before = bodiesOfFragments(session);
        }
        QCOMPARE(before, std::size_t{test::onlyAsset(session.scene()).bake->fragmentCount()});
    }
    void clusterBreaksFurtherWhenItIsHitAgain() {
        Session session = test::sessionOf(test::clusteredWall());
        test::addInput(session, ShotInput{"ball", test::ballAtWall()});
        while (session.events().splits.empty() && session.stepsDone() < 60) session.step();
        const auto cluster = std::ranges::find_if(
            session.bodies(), [&](const PlayBody& body) { return body.isDebris() && body.nodes.size() > 10; });
        QVERIFY(cluster != session.bodies().end());
        const std::uint32_t number = cluster->number;
        const std::size_t bodies = bodiesOfFragments(session);
        test::addInput(session, ShotInput{"blow", Hammer{.at = session.world().state(cluster->body).centre,
                                                         .impulse = {0.0, -3000.0, 0.0}}});
        session.step();
        QVERIFY(bodiesOfFragments(session) > bodies);
        QVERIFY(session.body(number)->nodes.size() > 1);
        QVERIFY(areClustersWhole(session, 1));
        QVERIFY(bondsOfLevel(session, 1).second > 0);
        QCOMPARE(bondsOfLevel(session, 2).second, std::size_t{0});
    }
    void blastBreaksBondsBetweenClustersOnly() {
        const Blast blast{.at = {0.0, 1.5, 0.3}, .impulse = 400.0, .radius = 1.0};
        const Session session = thrownAt(test::clusteredWall(), blast, 1);
        const PlayStructure& structure = *session.scene().structures.begin()->second;
        const InstanceDamage damage = session.damage().begin()->second;
        std::size_t broken = 0;
        for (std::size_t k = 0; k < structure.clusterLevels.size(); ++k) {
            const double distance = glm::distance(structure.graph.bonds[k].centroid, Vec3(0.0, 0.0, 0.3));
            QCOMPARE(bool(damage.broken[k]), distance <= 0.75 && structure.clusterLevels[k] == 0);
            broken += damage.broken[k] ? 1 : 0;
        }
        QVERIFY(broken > 5);
    }
    /// The lintel of a portal without one of its piers comes off in clusters, of which none has support.
    void clustersCollapseAsOne() {
        Project project = test::bondedPortal(0.7, 0.2);
        Asset& asset = project.assets[0];
        const Bake baked = *bake(asset);
        asset.bonding.clusters = ClusterEditing(asset, baked, 0, 0).propose({ClusterTarget::Measure::Size, 4});
        Session session = test::sessionOf(project);
        QVERIFY(areClustersWhole(session, 0));
        test::addInput(session, ShotInput{"blast", Blast{.at = {-1.75, 0.2, 0.0}, .impulse = 2e5, .radius = 0.7}});
        session.step();
        const std::size_t standing = test::wallOf(session).nodes.size();
        for (int k = 0; k < 14; ++k) session.step();
        QVERIFY(areClustersWhole(session, 0));
        QCOMPARE(bondsOfLevel(session, 1).second, std::size_t{0});
        QVERIFY2(test::wallOf(session).nodes.size() + 8 <= standing, QByteArray::number(standing));
        QVERIFY(test::wallOf(session).isHeld && test::wallOf(session).collapseStep == PlayBody::kNever);
    }
    /// A bar of 8 x 2 fragments, of which the lowest at both ends are anchored until the right one is removed: within
    /// the span then are the first four columns. A cluster of one of those with two of the next column keeps its bonds,
    /// also those to what has support.
    void clustersWithSupportKeepTheirBonds() {
        Project project = test::bondedWall(1, 1e4);
        Asset& asset = project.assets[0];
        asset.prism().outline = {rectangle({0.0, 0.0}, {8.0, 2.0}), {}};
        asset.pattern = test::patternOf(project, {JitteredGrid{.columns = 8, .rows = 2, .jitter = 0.0}});
        asset.bonding.span = 3.2;
        asset.bonding.collapseDelay = 0.05;
        asset.bonding.strokes = {{.radius = 0.1, .points = {{0.5, 0.5}}}, {.radius = 0.1, .points = {{7.5, 0.5}}}};
        project.instances[0].pose.position = {0.0, 5.0, 0.0};
        const Bake baked = *bake(asset);
        FragmentCluster cluster;
        FragmentPath last;
        for (std::uint32_t node = 0; node < baked.fragmentCount(); ++node) {
            const Vec3 centre = baked.fragment(node).solid.offset();
            const auto column = static_cast<int>(centre.x);
            if (column == 7 && centre.y < 1.0) last = baked.fragmentPath(node);
            if (column == 4 || (column == 3 && centre.y < 1.0)) cluster.fragments.push_back(baked.fragmentPath(node));
        }
        asset.bonding.clusters = {cluster};
        sortClusters(asset.bonding.clusters);
        Session session = test::sessionOf(project);
        test::addInput(session, RemoveInput{{project.instances[0].id, {last}}});
        for (int k = 0; k < 20; ++k) session.step();
        QCOMPARE(test::wallOf(session).nodes.size(), std::size_t{10});
        const PlayStructure& structure = *session.scene().structures.begin()->second;
        const InstanceDamage damage = session.damage().begin()->second;
        for (std::uint32_t bond = 0; bond < structure.graph.bondCount(); ++bond) {
            const Bond& one = structure.graph.bonds[bond];
            if (one.second == kNone) continue;
            const double right = std::max(structure.graph.centres[one.first].x, structure.graph.centres[one.second].x);
            QCOMPARE(bool(damage.broken[bond]), right > 5.0);
        }
    }
    void smallClustersFallApart() {
        Project project = test::clusteredWall(300, 60);  // about five fragments each
        project.assets[0].bonding.minimumIsland = 300;
        Session session = test::sessionOf(project);
        test::addInput(session, ShotInput{"ball", test::ballAtWall()});
        while (session.events().splits.empty() && session.stepsDone() < 60) session.step();
        for (const PlayBody& body : session.bodies()) QVERIFY(!body.isDebris() || body.nodes.empty());
    }
    void whatWouldFallKnowsClusters() {
        Project project = test::bondedPortal(0.7, 0.2);
        const auto massWithout = [&](const Project& one) {
            const Session session = test::sessionOf(one);
            const std::uint32_t number = test::wallOf(session).number;
            std::vector<std::uint32_t> pier;  // the left one, at its foot
            const Bake& baked = *test::onlyAsset(session.scene()).bake;
            for (std::uint32_t node = 0; node < baked.fragmentCount(); ++node) {
                const Vec3 offset = baked.fragment(node).solid.offset();
                if (offset.x < -1.4 && offset.y < -0.5) pier.push_back(node);
            }
            return wouldFall(session, std::vector<BodyPart>{{number, pier}})->mass;
        };
        const double single = massWithout(project);
        QVERIFY(single > 0.0);
        Asset& asset = project.assets[0];
        asset.bonding.clusters = ClusterEditing(asset, *bake(asset), 0, 0).propose({.value = 1});
        asset.bonding.clusters.front().fragments.pop_back();  // all but one: held by the right pier, it stays
        const double whole = massWithout(project);
        QVERIFY2(whole < single, QByteArray::number(whole));
    }
    /// Random throws at random walls in clusters: in each step bonds of one level of a body break, deeper ones later.
    void deeperLevelsWaitForCoarserOnes() {
        std::size_t broken = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            Random random(seed);
            Project project = test::clusteredWall(60 + static_cast<std::uint32_t>(random.below(60)),
                                                  3 + static_cast<std::uint32_t>(random.below(6)));
            project.assets[0].bonding.span = random.below(2) == 0 ? 0.0 : 1.5;
            project.assets[0].bonding.collapseDelay = random.below(2) == 0 ? 0.0 : 0.1;
            project.instances[0].isAnchored = random.below(3) > 0;
            Session session = test::sessionOf(project);
            for (int k = 0; k < 4; ++k) {
                const Vec2 at{random.between(-1.5, 1.5), random.between(0.3, 2.7)};
                session
                    .add(TimedInput{static_cast<std::uint64_t>(20 * k),
                                    ShotInput{"ball", test::ballAtWall(at, random.between(50.0, 500.0))}})
                    .value();
            }
            for (int k = 0; k < 120; ++k) {
                const std::map<std::uint32_t, std::vector<std::uint32_t>> before = nodesOf(session);
                const std::vector<bool> was = session.damage().begin()->second.broken;
                session.step();
                const std::string fault = faultOfStep(session, before, was, broken);
                QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            }
        }
        QVERIFY2(broken > 1000, QByteArray::number(broken));
    }
    void sameBitsOnAllThreads() {
        const Session one = thrownAt(test::clusteredWall(), test::ballAtWall(), 120);
        for (const int threads : {2, 8}) {
            const Session other = thrownAt(test::clusteredWall(), test::ballAtWall(), 120, {.threads = threads});
            QVERIFY(other.hash() == one.hash() && other.damage() == one.damage());
        }
    }

private:
    static std::map<std::uint32_t, std::vector<std::uint32_t>> nodesOf(const Session& session) {
        std::map<std::uint32_t, std::vector<std::uint32_t>> nodes;
        for (const PlayBody& body : session.bodies()) {
            if (body.bondedFracture() == nullptr) continue;
            nodes[body.number] = body.nodes;
            if (!body.nodes.empty()) continue;
            for (std::uint32_t k = 0; k < body.bondedFracture()->count; ++k) nodes[body.number].push_back(k);
        }
        return nodes;
    }
    /// What is wrong with the bonds that broke in a step: in each body only those of its least level may.
    static std::string faultOfStep(const Session& session,
                                   const std::map<std::uint32_t, std::vector<std::uint32_t>>& before,
                                   const std::vector<bool>& was, std::size_t& broken) {
        const PlayStructure& structure = *session.scene().structures.begin()->second;
        const std::vector<bool> is = session.damage().begin()->second.broken;
        for (const auto& [number, nodes] : before) {
            std::vector<BondDamage> damage;
            for (std::size_t bond = 0; bond < structure.graph.bondCount(); ++bond)
                damage.push_back(was[bond] ? kBroken : kIntact);
            const int least =
                breakingLevel(structure.graph, structure.capacities, structure.clusterLevels, damage, nodes);
            for (std::size_t bond = 0; bond < structure.clusterLevels.size(); ++bond) {
                if (was[bond] || !is[bond] || !std::ranges::binary_search(nodes, structure.graph.bonds[bond].first))
                    continue;
                ++broken;
                if (structure.clusterLevels[bond] > least) return "a deeper level broke in the same step";
            }
        }
        return "";
    }
};

RUBBLE_TEST(ClusterBreakingTest)
#include "ClusterBreakingTest.moc"
