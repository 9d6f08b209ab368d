#include "viewport/scene/play/StructureLines.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "viewport/scene/play/OverlayColours.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <set>

using namespace rubble;

namespace {

/// A bonded wall that weak blows damage.
Project softenedWall(std::uint32_t pieces) {
    Project project = test::bondedWall(pieces, 1e4);
    project.assets[0].bonding.damageFrom = 0.05;
    return project;
}

/// A bonded wall that a hammer strikes, and what is drawn of it.
struct StruckWall {
    explicit StruckWall(double impulse, const PlayOverlays& overlays = {}, std::uint32_t pieces = 60)
        : played(test::playSceneOf(softenedWall(pieces))),
          session(Session::start(played, {}).value()),
          builder(played) {
        builder.setOverlays(overlays);
        strike(impulse);
    }

    void strike(double impulse) {
        if (impulse > 0.0)
            test::addInput(session, ShotInput{"hammer", Hammer{{0.0, 1.6, 0.125}, {0.0, 0.0, -impulse}, {}}});
        session.step();
        moment = builder.sceneOf(session);
    }
    /// The number of bonds that are damaged and unbroken, and broken, between fragments of the wall.
    std::pair<int, int> damagedAndBroken() const {
        int damaged = 0, broken = 0;
        for (const StructureState& state : session.structures()) {
            for (std::uint32_t k = 0; k < state.damage.size(); ++k) {
                const Bond& bond = state.structure->graph.bonds[k];
                if (bond.second == kNone || state.bodyOfNode[bond.first] != state.bodyOfNode[bond.second]) continue;
                if (state.damage[k] != kIntact) ++(state.damage[k] == kBroken ? broken : damaged);
            }
        }
        return {damaged, broken};
    }

    std::shared_ptr<const PlayScene> played;
    Session session;
    SessionSceneBuilder builder;
    std::shared_ptr<const RenderScene> moment;
};

bool isCrack(const SceneLine& line) { return line.to.w == static_cast<float>(LineEnd::OnSurface); }

}  // namespace

class StructureLinesTest : public QObject {
    Q_OBJECT
private slots:
    void intactWallHasNoCracks() {
        const StruckWall wall(0.0);
        QVERIFY(wall.moment->lines.empty());
    }
    void damagedBondsAreCracksOnBothFaces() {
        const StruckWall wall(200.0);
        const auto [damaged, broken] = wall.damagedAndBroken();
        QVERIFY2(damaged > 0 && broken == 0, qPrintable(QString("%1, %2").arg(damaged).arg(broken)));
        QVERIFY(wall.moment->lines.size() >= 2 * static_cast<std::size_t>(damaged));
        std::set<int> sides;
        for (const SceneLine& line : wall.moment->lines) {
            QVERIFY(isCrack(line));
            const Vec3 from = wall.moment->origin + Vec3(line.from);
            QVERIFY(std::abs(std::abs(from.z) - 0.125) < 1e-5);  // on the front or the back
            sides.insert(from.z > 0.0 ? 1 : -1);
        }
        QCOMPARE(sides.size(), std::size_t{2});
    }
    void cracksDarkenWithDamage() {
        StruckWall wall(200.0);
        const float before = wall.moment->lines.front().colour.w;
        wall.strike(200.0);
        float darkest = 0.0f;
        for (const SceneLine& line : wall.moment->lines) darkest = std::max(darkest, line.colour.w);
        QVERIFY(darkest > before);
    }
    void whatCameOffHasNoCracksToTheRest() {
        const StruckWall wall(1e5);
        QVERIFY(wall.session.bodies().size() > 2);
        const auto [damaged, broken] = wall.damagedAndBroken();
        std::size_t edges = 0;
        for (const SceneLine& line : wall.moment->lines) edges += isCrack(line);
        QVERIFY((edges == 0) == (damaged + broken == 0));
    }
    void cracksMoveWithTheirBody() {
        Project project = test::bondedWall(60, 1e4);
        project.instances[0].isAnchored = false;
        project.instances[0].pose.position.y = 5.0;
        const auto played = test::playSceneOf(project);
        Session session = Session::start(played, {}).value();
        SessionSceneBuilder builder(played);
        test::addInput(session, ShotInput{"hammer", Hammer{{0.0, 5.1, 0.125}, {0.0, 0.0, -200.0}, {}}});
        for (int k = 0; k < 20; ++k) {
            session.step();
            builder.sceneOf(session);
        }
        const auto moment = builder.sceneOf(session);
        QVERIFY(!moment->lines.empty());
        const double speed = session.world().state(session.body(1)->body).velocity.y;
        for (const SceneLine& line : moment->lines)
            QVERIFY(std::abs(line.previousOffset.y + speed * session.stepLength()) < 0.02);
    }
    void removedDebrisHasNoCracks() {
        Project project = softenedWall(60);
        project.debris = {.lifetime = 0.2, .fade = 0.1};
        const auto played = test::playSceneOf(project);
        Session session = Session::start(played, {}).value();
        SessionSceneBuilder builder(played);
        test::addInput(session, ShotInput{"blast", Blast{.at = {0.0, 2.0, 0.5}, .impulse = 4e4, .radius = 2.0}});
        std::size_t removed = 0;
        for (int k = 0; k < 60; ++k) {
            session.step();
            builder.sceneOf(session);
            for (const PlayRemoval& one : session.events().removed) removed += one.body.nodes.size() > 1;
        }
        QVERIFY(removed > 0);  // with cracks between their fragments
    }
    void bondsAreColouredByDamage() {
        const StruckWall wall(200.0, {.hasBonds = true});
        const std::size_t bonds = wall.session.scene().structures.begin()->second->graph.bondCount();
        std::set<std::tuple<float, float, float>> colours;
        std::size_t lines = 0;
        for (const SceneLine& line : wall.moment->lines) {
            if (isCrack(line)) continue;
            ++lines;
            colours.insert({line.colour.x, line.colour.y, line.colour.z});
        }
        QCOMPARE(lines, bonds);
        QVERIFY(colours.size() > 1);
        const Colour intact = heatColour(0.0);
        QVERIFY(colours.contains(
            {static_cast<float>(intact.red), static_cast<float>(intact.green), static_cast<float>(intact.blue)}));
    }
    void brokenBondsHaveNoLine() {
        const StruckWall wall(1e5, {.hasBonds = true});
        const StructureState& state = wall.session.structures().front();
        std::size_t unbroken = 0, lines = 0;
        for (const BondDamage damage : state.damage) unbroken += damage != kBroken;
        for (const SceneLine& line : wall.moment->lines) lines += !isCrack(line);
        QVERIFY(unbroken < state.damage.size());
        QCOMPARE(lines, unbroken);
    }
    void bodiesHaveTheirOwnColours() {
        const StruckWall wall(1e5, {.hasBodies = true});
        std::set<std::uint32_t> colours;
        for (std::size_t k = 0; k < wall.moment->appearances.size(); ++k) {
            if ((wall.moment->appearances[k].marks & kHidden) == 0) colours.insert(wall.moment->appearances[k].outside);
        }
        QCOMPARE(colours.size(), wall.session.bodies().size() - 1);  // all but the ground
    }
};

RUBBLE_TEST(StructureLinesTest)
#include "StructureLinesTest.moc"
