// Tests core/play/breaking/MortarSupport.cpp, core/play/scene/JoinedSupport.cpp and core/play/state/KeptSupport.h.
#include "core/play/breaking/MortarSupport.h"

#include "core/play/scene/SupportProblems.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/MortarPortal.h"

using namespace rubble;
using test::addInput;

namespace {

constexpr std::uint32_t kLeftPier = 1, kLowerBeam = 3, kUpperWall = 4;  // numbers of the bodies

/// The portal, with a wall on all of its beam. All but the piers have the span, m.
Project portalWithWall(double span) {
    Project project = test::mortarPortal();
    for (Asset& asset : project.assets) asset.bonding.collapseDelay = 0.1;
    project.assets[1].bonding.span = span;
    Asset wall = project.assets[1];
    wall.name = "wall";
    const Id id = test::addAsset(project, wall, {UniformScatter{.count = 20}});
    test::addInstance(project, id, "wall", {.position = {0.0, 4.5, 0.0}});
    return project;
}

UnsupportedNodes unsupportedIn(const Session& session) {
    const auto snapshot = session.snapshot();
    SessionState state = snapshot->state;
    World world({.gravity = session.world().gravity()});
    world.restore(*snapshot->world);
    const SessionSettings settings;
    std::set<Id> instances;
    for (const Instance& instance : session.scene().project.instances) instances.insert(instance.id);
    SessionParts parts{session.scene(), settings, state, world};
    return unsupportedByMortar(parts, joinedGroups(session.scene().structures, instances));
}

/// The nodes of a body that are beyond the span at the start.
std::vector<std::uint32_t> beyondSpan(const Session& session, std::uint32_t body) {
    return nodesBeyondSpan(*session.scene().structures.at(session.origins()[session.body(body)->origin].instance));
}

/// The fragments of an instance that are held, ascending.
std::vector<std::uint32_t> heldOf(const Session& session, std::uint32_t origin) {
    std::vector<std::uint32_t> held;
    for (const PlayBody& body : session.bodies()) {
        if (body.origin != origin || !body.isHeld) continue;
        const std::vector<std::uint32_t> fragments = bondedFragments(body);
        held.insert(held.end(), fragments.begin(), fragments.end());
    }
    std::ranges::sort(held);
    return held;
}

Session playedWithoutLeft(const Project& project) {
    Session session = test::sessionOf(project);
    addInput(session, BreakInput{kLeftPier});
    for (int k = 0; k < 8; ++k) session.step();  // the collapse delay, and before anything falls onto what stands
    return session;
}

}  // namespace

class MortarSupportTest : public QObject {
    Q_OBJECT
private slots:
    void allStandsOnBothPiers() {
        const Session session = test::sessionOf(portalWithWall(1.3));
        QVERIFY(unsupportedIn(session).empty());
        for (const std::uint32_t body : {kLowerBeam, kUpperWall}) QVERIFY(beyondSpan(session, body).empty());
    }
    void withoutSpanNothingIsUnsupported() {
        const Session session = playedWithoutLeft(portalWithWall(0.0));
        QVERIFY(unsupportedIn(session).empty());
        QCOMPARE(heldOf(session, session.body(kLowerBeam)->origin).size(), std::size_t{20});
    }
    /// The middle of the beam is 1 m from both piers.
    void aShortSpanNeedsMoreThanThePiers() {
        const Session session = test::sessionOf(portalWithWall(0.3));
        QVERIFY(!beyondSpan(session, kLowerBeam).empty());
        QVERIFY(unsupportedIn(session).empty());
        QVERIFY(unsupportedIn(playedWithoutLeft(portalWithWall(0.3))).empty());  // it has fallen
    }
    void whatIsBeyondTheSpanFalls() {
        const Session session = playedWithoutLeft(portalWithWall(0.5));
        for (const std::uint32_t body : {kLowerBeam, kUpperWall}) {
            const std::size_t held = heldOf(session, session.body(body)->origin).size();
            QVERIFY2(held >= 5 && held <= 17, QByteArray::number(static_cast<int>(held)));
        }
        QVERIFY(unsupportedIn(session).empty());
    }
    void theWallDoesNotHoldTheBeamThatCarriesIt() {
        Project project = portalWithWall(0.5);
        const Session with = playedWithoutLeft(project);
        project.instances.pop_back();
        const Session without = playedWithoutLeft(project);
        const std::uint32_t beam = with.body(kLowerBeam)->origin;
        QCOMPARE(heldOf(with, beam), heldOf(without, beam));
    }
    void whatHangsIsNotHeld() {
        Project project = portalWithWall(1.0);
        // The wall hangs below the beam, between the piers.
        project.assets[2].prism().outline = {rectangle({-0.9, -0.5}, {0.9, 0.5}), {}};
        project.instances[3].pose.position = {0.0, 2.5, 0.0};
        const Session session = test::sessionOf(project);
        QCOMPARE(beyondSpan(session, kUpperWall).size(), std::size_t{20});
        QVERIFY(beyondSpan(session, kLowerBeam).empty());
    }
    /// A bracket on the side of the right pier holds as far as its span, counted from the face of the pier.
    void mortarAtASideHolds() {
        Project project = portalWithWall(1.0);
        project.assets[2].prism().outline = {rectangle({-1.5, -0.5}, {1.5, 0.5}), {}};
        project.instances[3].pose.position = {3.5, 1.5, 0.0};
        const Session session = test::sessionOf(project);
        const std::vector<std::uint32_t> unsupported = beyondSpan(session, kUpperWall);
        const PlayStructure& wall = *session.scene().structures.at(project.instances[3].id);
        for (std::uint32_t node = 0; node < wall.nodeCount(); ++node) {
            const double distance = wall.graph.centres[node].x + 1.5;
            const bool isSupported = !std::ranges::binary_search(unsupported, node);
            QVERIFY(distance > 0.5 || isSupported);
            QVERIFY(distance <= 1.0 || !isSupported);
        }
    }
};

RUBBLE_TEST(MortarSupportTest)
#include "MortarSupportTest.moc"
