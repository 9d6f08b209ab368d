// Tests core/play/breaking/LooseMortar.cpp and core/play/state/BegunStructures.h.
#include "core/play/breaking/LooseMortar.h"

#include "core/base/DisjointSets.h"
#include "core/base/Random.h"
#include "core/play/breaking/BrokenBonds.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/state/SessionBodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/MortarArcade.h"

#include <algorithm>

using namespace rubble;

namespace {

/// Two portals, with a second wall upon each of their walls.
Project tallArcade() {
    Project project = test::mortarArcade(2);
    for (const std::size_t wall : {3, 7}) {
        Instance upper = project.instances[wall];
        upper.id = project.nextId++;
        upper.name += " upper";
        upper.pose.position.y += 1.0;
        project.instances.push_back(std::move(upper));
    }
    return project;
}

/// The state of a session, to be changed.
struct Changing {
    const Session& session;
    SessionSettings settings;
    SessionState state;
    World world;

    explicit Changing(const Session& of)
        : session(of), state(of.snapshot()->state), world({.gravity = of.world().gravity()}) {
        world.restore(*of.snapshot()->world);
    }
    SessionParts parts() { return {session.scene(), settings, state, world}; }
};

bool isBroken(const SessionState& state, Id instance, std::uint32_t bond) {
    const StructureState* one = BegunStructures(state).find(instance);
    return one != nullptr && one->damage[bond] == kBroken;
}

/// The same of all instances, node by node, with sets of all nodes that anything unbroken connects.
std::vector<MortarHalf> looseOfAll(const PlayScene& scene, const SessionState& state) {
    std::map<Id, std::uint32_t> first;
    std::uint32_t count = 1;  // 0: the anchors
    for (const auto& [id, structure] : scene.structures) {
        first[id] = count;
        count += structure->nodeCount();
    }
    DisjointSets sets(count);
    const auto forEachUnbroken = [&](const auto& visit) {
        for (const auto& [id, structure] : scene.structures) {
            for (std::uint32_t bond = 0; bond < structure->graph.bondCount(); ++bond)
                if (!isBroken(state, id, bond)) visit(id, *structure, bond);
        }
    };
    forEachUnbroken([&](Id id, const PlayStructure& structure, std::uint32_t bond) {
        const Bond& one = structure.graph.bonds[bond];
        const MortarLink* link = structure.mortarOf(bond);
        const std::uint32_t node = first[id] + one.first;
        if (link == nullptr) {
            sets.merge(node, one.second == kNone ? 0 : first[id] + one.second);
        } else if (!isBroken(state, link->instance, link->bond)) {
            const PlayStructure& other = *scene.structures.at(link->instance);
            sets.merge(node, first[link->instance] + other.graph.bonds[link->bond].first);
        }
    });
    std::vector<MortarHalf> loose;
    forEachUnbroken([&](Id id, const PlayStructure& structure, std::uint32_t bond) {
        const MortarLink* link = structure.mortarOf(bond);
        if (link == nullptr) return;
        const bool isHeld = sets.rootOf(first[id] + structure.graph.bonds[bond].first) == sets.rootOf(0);
        if (!isHeld || isBroken(state, link->instance, link->bond)) loose.push_back({id, bond});
    });
    return loose;
}

/// Removes a held body, or a random half of its nodes, and leaves the mortar around it as it is. Returns its instance.
Id removeSome(Changing& changing, Random& random) {
    std::vector<std::uint32_t> held;
    for (const PlayBody& body : changing.state.bodies)
        if (body.isHeld && body.bondedFracture() != nullptr) held.push_back(body.number);
    if (held.empty()) return 0;
    PlayBody& body = *findBody(changing.state, held[random.below(held.size())]);
    const Id instance = changing.state.origins[body.origin].instance;
    SessionParts parts = changing.parts();
    structureOf(parts, body);
    std::vector<std::uint32_t> nodes = body.nodes;
    if (random.below(2) == 0) std::erase_if(nodes, [&](std::uint32_t) { return random.below(2) == 0; });
    if (!nodes.empty()) removeNodes(parts, body.number, nodes);
    return instance;
}

/// Removes the body of an intact instance.
void removeWhole(Changing& changing, Id instance) {
    const auto isIts = [&](const PlayBody& body) { return changing.state.origins[body.origin].instance == instance; };
    PlayBody& body = *std::ranges::find_if(changing.state.bodies, isIts);
    SessionParts parts = changing.parts();
    structureOf(parts, body);
    removeNodes(parts, body.number, std::vector<std::uint32_t>(body.nodes));
}

/// How many instances are looked at when a portal has lost its beam.
std::size_t visitsWithoutBeam(int portals, std::size_t portal) {
    const Project project = test::mortarArcade(portals);
    const Session session = test::sessionOf(project);
    Changing changing(session);
    const Id beam = project.instances[4 * portal + 2].id;
    removeWhole(changing, beam);
    SessionParts parts = changing.parts();
    const LooseMortar loose = looseMortar(parts, BegunStructures(changing.state), {beam});
    if (loose.halves.empty()) qFatal("the beam held nothing");
    return loose.visits;
}

}  // namespace

class LooseMortarTest : public QObject {
    Q_OBJECT
private slots:
    /// What is found from the instances that changed is all that there is.
    void theSearchFindsAllOfTheScene() {
        std::size_t found = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random(seed);
            const Session session = test::sessionOf(tallArcade());
            Changing changing(session);
            for (int round = 0; round < 12; ++round) {
                std::set<Id> changed;
                for (std::uint64_t k = random.below(3) + 1; k > 0; --k) changed.insert(removeSome(changing, random));
                SessionParts parts = changing.parts();
                for (;;) {
                    const auto loose = looseMortar(parts, BegunStructures(changing.state), changed).halves;
                    QCOMPARE(loose, looseOfAll(session.scene(), changing.state));
                    found += loose.size();
                    if (loose.empty()) break;
                    changed = breakHalves(parts, loose);
                }
            }
        }
        QVERIFY(found > 100);
    }
    /// All that stood on the beams, at once.
    void whatStoodOnWhatIsGoneIsLoose() {
        const Project project = tallArcade();
        const Session session = test::sessionOf(project);
        Changing changing(session);
        const std::set<Id> beams{project.instances[2].id, project.instances[6].id};
        for (const Id beam : beams) removeWhole(changing, beam);
        SessionParts parts = changing.parts();
        const std::vector<MortarHalf> loose = looseMortar(parts, BegunStructures(changing.state), beams).halves;
        QCOMPARE(loose, looseOfAll(session.scene(), changing.state));
        std::set<Id> instances;
        for (const MortarHalf& half : loose) instances.insert(half.instance);
        QCOMPARE(instances.size(), std::size_t{8});  // but for the beams
    }
    void nothingIsLooseWhereNothingBroke() {
        const Project project = test::mortarArcade(2);
        const Session session = test::sessionOf(project);
        Changing changing(session);
        SessionParts parts = changing.parts();
        const LooseMortar loose = looseMortar(parts, BegunStructures(changing.state), {project.instances[2].id, 0});
        QVERIFY(loose.halves.empty() && loose.visits > 0);
        QCOMPARE(looseMortar(parts, BegunStructures(changing.state), {}).visits, std::size_t{0});
    }
    void theSearchStopsAtWhatIsAnchored() {
        const std::size_t visits = visitsWithoutBeam(12, 6);
        QVERIFY(visits < 4 * 12);
        QCOMPARE(visitsWithoutBeam(40, 20), visits);
    }

private:
    /// Breaks halves of mortar and takes the nodes at them out, so that no body has to be split. Returns the instances.
    static std::set<Id> breakHalves(SessionParts& parts, const std::vector<MortarHalf>& loose) {
        std::set<Id> changed;
        for (const auto& [instance, bond] : loose) {
            changed.insert(instance);
            for (PlayBody& body : parts.state().bodies) {
                if (body.role == PlayRole::Instance && parts.state().origins[body.origin].instance == instance)
                    structureOf(parts, body);
            }
            const std::uint32_t index = BegunStructures(parts.state()).indexOf(instance);
            StructureState& state = parts.state().structures[index];
            state.damage[bond] = kBroken;
            const std::uint32_t node = state.structure->graph.bonds[bond].first;
            if (const std::uint32_t number = state.bodyOfNode[node]; number != kNone)
                removeNodes(parts, number, {&node, 1});
        }
        return changed;
    }
};

RUBBLE_TEST(LooseMortarTest)
#include "LooseMortarTest.moc"
