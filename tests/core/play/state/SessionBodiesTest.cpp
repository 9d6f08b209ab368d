// Tests core/play/state/SessionBodies.cpp, core/play/state/SessionState.cpp, core/play/state/InputDiagnostics.cpp and
// core/play/scene/PlayBody.cpp.
#include "core/play/state/SessionBodies.h"

#include "core/play/state/InputDiagnostics.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/play/Sessions.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

using namespace rubble;

namespace {

/// The bodies of a project in a world, without a session.
struct PlacedBodies {
    explicit PlacedBodies(const Project& project) : scene(test::playSceneOf(project)) {
        if (const Status placed = placeScene(parts); !placed) qFatal("%s", placed.error().message.c_str());
    }
    std::shared_ptr<const PlayScene> scene;
    SessionSettings settings;
    SessionState state;
    World world;
    SessionParts parts{*scene, settings, state, world};
};

/// A block at a height of 5 m, and its first fragment 3 m below.
struct BlockAndFragment : PlacedBodies {
    BlockAndFragment() : PlacedBodies(test::floatingBlock()) {
        const std::shared_ptr<const PlayAsset> asset = state.bodies.back().asset;
        const Result<std::uint32_t> added =
            addBody(parts, {.shape = asset->solid(0).shape, .pose = {.position = {0.0, 2.0, 0.0}}},
                    {.role = PlayRole::Debris, .origin = state.bodies.back().origin, .asset = asset, .fragment = 0});
        if (!added) qFatal("%s", added.error().message.c_str());
    }
    const PlayBody& block() const { return state.bodies[state.bodies.size() - 2]; }
    const PlayBody& fragment() const { return state.bodies.back(); }
};

// Through parts that are const, nothing of a session can be changed, not even by a copy.
template <class Parts>
concept CanChange = requires(Parts& parts) {
    parts.state().step = 1;
}
|| requires(Parts& parts) { parts.world().release(); }
|| requires(Parts& parts) { SessionParts(parts); };
static_assert(CanChange<SessionParts> && !CanChange<const SessionParts>);
static_assert(std::is_same_v<decltype(findBody(std::declval<const SessionState&>(), 0)), const PlayBody*>);

}  // namespace

class SessionBodiesTest : public QObject {
    Q_OBJECT
private slots:
    void sceneIsGroundAndInstances() {
        const PlacedBodies placed(test::floatingBlock());
        QCOMPARE(placed.state.bodies.size(), std::size_t{2});
        QVERIFY(placed.state.bodies[0].role == PlayRole::Ground);
        QVERIFY(placed.state.bodies[1].role == PlayRole::Instance);
        QCOMPARE(placed.state.bodies[1].number, 1u);
        QCOMPARE(placed.world.state(placed.state.bodies[1].body).pose.position, Vec3(0.0, 5.0, 0.0));
        Project empty = test::floatingBlock();
        empty.ground.isOn = false;
        QCOMPARE(PlacedBodies(empty).state.bodies.size(), std::size_t{1});
    }
    void bodiesHaveNamesAndPlaces() {
        const BlockAndFragment bodies;
        const PlayOrigin& origin = bodies.state.origins.back();
        QCOMPARE(nameOf(bodies.block(), origin), "block");
        const std::string path = bodies.fragment().asset->bake->fragmentPath(0);
        QCOMPARE(nameOf(bodies.fragment(), origin), "block/" + path);
        QVERIFY(placeOf(bodies.state.bodies[0]) == DiagnosticPlace{});
        QVERIFY((placeOf(bodies.block()) == DiagnosticPlace{.asset = origin.asset}));
        QVERIFY((placeOf(bodies.fragment()) == DiagnosticPlace{.asset = origin.asset, .fragment = 0, .path = path}));
    }
    void topIsThatOfTheHighestHull() {
        const BlockAndFragment bodies;
        QCOMPARE(topHeight(bodies.block(), bodies.world), 5.5);  // half a metre above its middle
        QCOMPARE(topHeight(bodies.state.bodies[0], bodies.world), bodies.scene->project.ground.height);
        QCOMPARE(hullsOf(bodies.block()).size(), std::size_t{1});
    }
    void onlyTheWholeBreaksAtTheThresholdOfItsInstance() {
        Project project = test::floatingBlock();
        project.instances[0].threshold = 7.0;
        PlacedBodies placed(project);
        PlayBody block = placed.state.bodies[1];
        QCOMPARE(thresholdOf(placed.state, *placed.scene, block), 7.0);
        block.isUnbreakable = true;
        QVERIFY(std::isinf(thresholdOf(placed.state, *placed.scene, block)));
        const BlockAndFragment bodies;  // a leaf does not break
        QVERIFY(std::isinf(thresholdOf(bodies.state, *bodies.scene, bodies.fragment())));
    }
    void removedBodiesAreErasedAndTheirNumbersNotReused() {
        BlockAndFragment bodies;
        QCOMPARE(findBody(bodies.state, 2)->number, 2u);
        QVERIFY(!findBody(bodies.state, 3));
        removeFromWorld(bodies.parts, 1);
        QVERIFY(findBody(bodies.state, 1));
        QCOMPARE(eraseRemovedBodies(bodies.state), std::size_t{3});
        QVERIFY(!findBody(bodies.state, 1));
        QCOMPARE(findBody(bodies.state, 2)->number, 2u);
        QCOMPARE(bodies.state.nextNumber, 3u);
    }
    void fragmentsOfTheThesisWeigh100Kilograms() {
        Project project = test::floatingBlock();
        project.damage.isThesis = true;
        PlacedBodies placed(project);
        const PlayAsset& asset = *placed.state.bodies[1].asset;
        const double volume = asset.solid(0).shape->mass.volume;
        QCOMPARE(bodyMaterial(placed.parts, asset, kNone, PlayRole::Instance).density, 1000.0);
        const double density = bodyMaterial(placed.parts, asset, 0, PlayRole::Debris).density;
        QVERIFY(std::abs(density * volume - 100.0) < 1e-9);
    }
    void memoryGrowsWithTheBodies() {
        SessionState state;
        const std::size_t before = byteCount(state);
        state.bodies.resize(100);
        QVERIFY(byteCount(state) >= before + 100 * sizeof(PlayBody));
    }
    void inputsWithoutEffectAreReported() {
        BlockAndFragment bodies;
        reportRefused(bodies.parts, &bodies.block(), "Impulse", success());
        QVERIFY(bodies.state.events.diagnostics.empty());
        reportRefused(bodies.parts, &bodies.block(), "Impulse", Error{ErrorCode::BadInput, "It is too large."});
        addUnapplied(bodies.parts, nullptr, "There is nothing.");
        QCOMPARE(bodies.state.events.diagnostics.size(), std::size_t{2});
        const Diagnostic& refused = bodies.state.events.diagnostics[0];
        QVERIFY(refused.code == DiagnosticCode::UnappliedInput);
        QCOMPARE(refused.message, "Impulse: It is too large.");
        QCOMPARE(refused.place.asset, bodies.state.origins.back().asset);
        QVERIFY(bodies.state.events.diagnostics[1].place == DiagnosticPlace{});
    }
    void lostImpulsesAreReported() {
        BlockAndFragment bodies;
        const BodyId block = bodies.block().body;
        QVERIFY(applyImpulse(bodies.parts, block, {500.0, 0.0, 0.0}, {0.0, 5.0, 0.0}, "The hit on \"block\""));
        QVERIFY(bodies.state.events.diagnostics.empty());
        QCOMPARE(bodies.world.state(block).velocity, Vec3(1.0, 0.0, 0.0));
        for (const double impulse : {2.0 * kMaxImpulse, std::numeric_limits<double>::quiet_NaN()}) {
            bodies.state.events.diagnostics.clear();
            QVERIFY(!applyImpulse(bodies.parts, block, Vec3(impulse), {0.0, 5.0, 0.0}, "The hit on \"block\""));
            QCOMPARE(bodies.world.state(block).velocity, Vec3(1.0, 0.0, 0.0));
            QCOMPARE(bodies.state.events.diagnostics.size(), std::size_t{1});
            const Diagnostic& lost = bodies.state.events.diagnostics[0];
            QVERIFY(lost.code == DiagnosticCode::UnappliedInput);
            QCOMPARE(lost.message,
                     "The hit on \"block\": An impulse must be finite and at most 1e+24 N·s along each axis.");
            QVERIFY(lost.place == placeOf(bodies.block()));
        }
    }
};

RUBBLE_TEST(SessionBodiesTest)
#include "SessionBodiesTest.moc"
