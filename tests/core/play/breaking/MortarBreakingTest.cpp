#include "core/play/breaking/MortarBreaking.h"

#include "core/base/Random.h"
#include "core/play/state/SessionState.h"
#include "core/structure/clusters/ClusterEditing.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/MortarPortal.h"

#include <set>

using namespace rubble;
using test::addInput;

namespace {

constexpr std::uint32_t kLeft = 1, kRight = 2, kBeam = 3;  // numbers of the bodies

Session started(const Project& project) { return Session::start(test::playSceneOf(project), {}).value(); }

void step(Session& session, int steps) {
    for (int k = 0; k < steps; ++k) session.step();
}

/// The bodies of an instance that are held.
int heldBodies(const Session& session, std::uint32_t origin) {
    int held = 0;
    for (const PlayBody& body : session.bodies()) held += body.origin == origin && body.isHeld ? 1 : 0;
    return held;
}

/// Whether each node of a held body leads to an anchor that is no mortar, over unbroken bonds and mortar, and the
/// halves of mortar are broken together: by a search node by node.
QString faultOfMortar(const Session& session) {
    const std::shared_ptr<const SessionSnapshot> snapshot = session.snapshot();
    const SessionState& state = snapshot->state;
    using Node = std::pair<Id, std::uint32_t>;
    const auto stateOf = [&](Id instance) -> const StructureState* {
        for (const StructureState& one : state.structures)
            if (one.parent == kNone && state.origins[one.origin].instance == instance) return &one;
        return nullptr;
    };
    const auto isBroken = [&](Id instance, std::uint32_t bond) {
        const StructureState* one = stateOf(instance);
        return one != nullptr && one->damage[bond] == kBroken;
    };
    const auto damageOf = [&](Id instance, std::uint32_t bond) {
        const StructureState* one = stateOf(instance);
        return one != nullptr ? one->damage[bond] : kIntact;
    };
    std::set<Node> reached;
    std::vector<Node> next;
    const auto reach = [&](Node node) {
        if (reached.insert(node).second) next.push_back(node);
    };
    for (const auto& [id, structure] : session.scene().structures) {
        for (std::uint32_t bond = 0; bond < structure->graph.bondCount(); ++bond) {
            const MortarLink* link = structure->mortarOf(bond);
            if (link != nullptr && isBroken(id, bond) != isBroken(link->instance, link->bond)) return "half a mortar";
            if (link != nullptr && damageOf(id, bond) != damageOf(link->instance, link->bond)) return "unlike halves";
            const Bond& one = structure->graph.bonds[bond];
            if (one.second == kNone && link == nullptr && !isBroken(id, bond)) reach({id, one.first});
        }
    }
    while (!next.empty()) {
        const auto [id, node] = next.back();
        next.pop_back();
        const PlayStructure& structure = *session.scene().structures.at(id);
        for (const BondLink& link : structure.graph.linksOf(node)) {
            if (isBroken(id, link.bond)) continue;
            if (link.node != kNone) reach({id, link.node});
            const MortarLink* mortar = structure.mortarOf(link.bond);
            if (mortar == nullptr) continue;
            const PlayStructure& other = *session.scene().structures.at(mortar->instance);
            reach({mortar->instance, other.graph.bonds[mortar->bond].first});
        }
    }
    for (const PlayBody& body : session.bodies()) {
        if (!body.isHeld || body.nodes.empty()) continue;
        for (const std::uint32_t node : body.nodes)
            if (!reached.contains({state.origins[body.origin].instance, node})) return "held by nothing";
    }
    return {};
}

/// Parts each asset of a project into clusters of one level.
void addClusters(Project& project, std::uint32_t count) {
    for (Asset& asset : project.assets) {
        const Bake made = bake(asset).value();
        asset.bonding.clusters = ClusterEditing(asset, made, 0, 0).propose({ClusterTarget::Measure::Number, count});
    }
}

/// A body that has parts of several clusters has all of each: they break apart only on their own.
bool areClustersWhole(const Session& session) {
    for (const PlayBody& body : session.bodies()) {
        if (body.bondedFracture() == nullptr || body.nodes.empty()) continue;
        const Asset& asset = *findAsset(session.scene().project, session.origins()[body.origin].asset);
        const std::vector<std::uint32_t> clusters = clustersOfFragments(asset, *body.asset->bake, 0)[0];
        std::set<std::uint32_t> found;
        for (const std::uint32_t node : body.nodes) found.insert(clusters[node]);
        if (found.size() < 2) continue;
        for (std::uint32_t node = 0; node < clusters.size(); ++node) {
            if (found.contains(clusters[node]) && !std::ranges::binary_search(body.nodes, node)) return false;
        }
    }
    return true;
}

/// Throws a ball at a random place of the portal.
void throwAtPortal(Session& session, Random& random) {
    const Vec3 to(random.between(-2.0, 2.0), random.between(0.2, 4.0), 0.0);
    addInput(session, ShotInput{"ball", Throw{.size = {0.4, 0.4, 0.4},
                                              .mass = random.between(50.0, 800.0),
                                              .from = to + Vec3(random.between(-2.0, 2.0), 0.5, 4.0),
                                              .to = to,
                                              .speed = random.between(5.0, 40.0)}});
}

}  // namespace

class MortarBreakingTest : public QObject {
    Q_OBJECT
private slots:
    void joinedInstancesStand() {
        Session session = started(test::mortarPortal());
        const Vec3 before = session.world().state(session.body(kBeam)->body).centre;
        step(session, 600);
        QVERIFY(session.body(kBeam)->isHeld);
        QCOMPARE(session.world().state(session.body(kBeam)->body).centre, before);
    }
    /// It hangs on the other pier, as nothing limits the span.
    void oneSupportIsEnough() {
        for (const std::uint32_t broken : {kLeft, kRight}) {
            Session session = started(test::mortarPortal());
            addInput(session, BreakInput{broken});
            step(session, 120);
            QVERIFY(session.body(kBeam)->isHeld);
            QVERIFY(session.body(broken == kLeft ? kRight : kLeft)->isHeld);
            QCOMPARE(faultOfMortar(session), "");
        }
    }
    /// The left pier is fixed in the air, and holds the others also where a fragment of it came off.
    void whatIsFixedInTheAirHoldsTheOthers() {
        Project project = test::mortarPortal();
        for (Instance& instance : project.instances) {
            instance.pose.position.y += 5.0;
            instance.isAnchored = false;
        }
        project.instances[0].isFixed = true;
        Session session = started(project);
        QVERIFY(session.body(kLeft)->isHeld && session.body(kBeam)->isHeld);
        addInput(session, ShotInput{"blast", Blast{.at = {-1.5, 4.9, 0.0}, .impulse = 800.0, .radius = 1.0}});
        step(session, 10);
        QVERIFY(session.body(kLeft)->nodes.size() > 1 && session.body(kLeft)->nodes.size() < 20);
        QVERIFY(session.body(kLeft)->isHeld && session.body(kBeam)->isHeld);
    }
    void whatNothingHoldsFalls() {
        Session session = started(test::mortarPortal());
        const double before = session.world().state(session.body(kBeam)->body).centre.y;
        addInput(session, BreakInput{kLeft});
        addInput(session, BreakInput{kRight});
        step(session, 240);  // the rubble of the piers slows it
        QVERIFY(!session.body(kBeam)->isHeld);
        QVERIFY(session.world().state(session.body(kBeam)->body).centre.y < before - 1.0);
        QCOMPARE(faultOfMortar(session), "");
    }
    void partsThatBreakLeaveTheOthersStanding() {
        Session session = started(test::mortarPortal());
        addInput(session, BreakInput{kBeam});
        step(session, 120);
        QCOMPARE(heldBodies(session, session.body(kLeft)->origin), 1);
        QCOMPARE(heldBodies(session, session.body(kRight)->origin), 1);
        for (const PlayBody& body : session.bodies()) QVERIFY(body.origin != 3 || !body.isHeld);
        QCOMPARE(faultOfMortar(session), "");
    }
    void hitAtTheJointBreaksMortar() {
        Session session = started(test::mortarPortal(50.0));
        addInput(session, ShotInput{"ball", Throw{.size = {0.4, 0.4, 0.4},
                                                  .mass = 200.0,
                                                  .from = {-1.5, 2.95, 3.0},
                                                  .to = {-1.5, 2.95, 0.0},
                                                  .speed = 10.0}});
        step(session, 60);
        const std::shared_ptr<const SessionSnapshot> snapshot = session.snapshot();
        std::size_t broken = 0;
        for (const StructureState& one : snapshot->state.structures) {
            for (std::uint32_t bond = one.structure->firstMortar(); bond < one.damage.size(); ++bond)
                broken += one.damage[bond] == kBroken ? 1 : 0;
        }
        QVERIFY(broken > 0 && broken % 2 == 0);
        QVERIFY(session.body(kBeam)->isHeld);  // by the right pier
        QCOMPARE(faultOfMortar(session), "");
    }
    void stateGoesOnWithTheSameBits() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        Session session = Session::start(scene, {}).value();
        addInput(session, BreakInput{kLeft});
        step(session, 20);
        const auto snapshot = session.snapshot();
        addInput(session, BreakInput{kRight});
        step(session, 60);
        Session again = Session::start(scene, {}).value();
        again.restore(*snapshot);
        addInput(again, BreakInput{kRight});
        step(again, 60);
        QCOMPARE(again.world().hash(), session.world().hash());
    }
    /// Damage that is applied breaks both halves, in whichever instance it is.
    void appliedDamageBreaksBothHalves() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        Session session = Session::start(scene, {}).value();
        addInput(session, BreakInput{kLeft});
        step(session, 1);
        SessionDamage damage = session.damage();
        const Id beam = scene->project.instances[2].id;
        std::erase_if(damage, [&](const auto& one) { return one.first != beam; });
        Session other = Session::start(scene, {}).value();
        QVERIFY(other.apply(damage).hasValue());
        QCOMPARE(faultOfMortar(other), "");
        QVERIFY(other.body(kLeft)->isHeld);
    }
    /// Mortar that breaks may leave a single fragment of a body that the same blast is about to reach.
    void randomBlastsKeepMortarConsistent() {
        constexpr std::uint64_t kSeed = 59;
        Random random(kSeed);
        for (int round = 0; round < 100; ++round) {
            Project project = test::mortarPortal(random.between(1.0, 300.0));
            for (Asset& asset : project.assets) {
                asset.bonding.span = random.between(0.2, 1.0);
                asset.bonding.collapseDelay = round % 2 == 0 ? 0.0 : 0.1;
                asset.bonding.minimumIsland = 1 + static_cast<std::uint32_t>(random.below(12));
            }
            Session session = started(project);
            for (int blast = 0; blast < 3; ++blast) {
                const Vec3 at(random.between(-2.0, 2.0), random.between(0.0, 4.0), random.between(-1.0, 1.0));
                addInput(session, ShotInput{"blast", Blast{.at = at,
                                                           .impulse = random.between(100.0, 2000.0),
                                                           .radius = random.between(0.5, 3.0)}});
                for (int k = 0; k < 20; ++k) {
                    session.step();
                    const QString fault = faultOfMortar(session);
                    QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1, round %2: ").arg(kSeed).arg(round) + fault));
                }
            }
        }
    }
    void randomHitsKeepMortarConsistent() {
        constexpr std::uint64_t kSeed = 53;
        Random random(kSeed);
        for (int round = 0; round < 60; ++round) {
            Session session = started(test::mortarPortal(random.between(20.0, 800.0)));
            for (int hit = 0; hit < 4; ++hit) {
                throwAtPortal(session, random);
                for (int k = 0; k < 40; ++k) {
                    session.step();
                    const QString fault = faultOfMortar(session);
                    QVERIFY2(fault.isEmpty(),
                             qPrintable(QString("seed %1, round %2, hit %3: ").arg(kSeed).arg(round).arg(hit) + fault));
                }
            }
        }
    }
    void joinedClustersComeOffWhole() {
        constexpr std::uint64_t kSeed = 59;
        Random random(kSeed);
        std::size_t cameOff = 0;
        for (int round = 0; round < 60; ++round) {
            Project project = test::mortarPortal(random.between(20.0, 800.0));
            addClusters(project, 4);
            for (Asset& asset : project.assets) asset.bonding.span = round % 2 == 0 ? 0.0 : random.between(0.5, 2.0);
            Session session = started(project);
            for (int hit = 0; hit < 3; ++hit) {
                throwAtPortal(session, random);
                for (int k = 0; k < 30; ++k) {
                    session.step();
                    const QString place = QString("seed %1, round %2, hit %3: ").arg(kSeed).arg(round).arg(hit);
                    const QString fault = faultOfMortar(session);
                    QVERIFY2(fault.isEmpty(), qPrintable(place + fault));
                    QVERIFY2(areClustersWhole(session), qPrintable(place + "a body has a part of a cluster"));
                }
            }
            for (const PlayBody& body : session.bodies()) cameOff += body.isDebris() && body.nodes.size() > 1 ? 1 : 0;
        }
        QVERIFY2(cameOff > 20, qPrintable(QString::number(cameOff)));
    }
};

RUBBLE_TEST(MortarBreakingTest)
#include "MortarBreakingTest.moc"
