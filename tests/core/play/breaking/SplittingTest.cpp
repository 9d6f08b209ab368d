#include "core/play/breaking/Splitting.h"

#include "core/play/session/Session.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace rubble;

namespace {

/// A bonded wall of two courses of bricks, 4 x 2 x 0.25 m times `scale`. Slices run beside their head joints: between
/// both, the mortar takes all of the stone.
Project columnsOfBricks(double scale, std::uint32_t columns) {
    Project project = test::bondedWall();
    Asset& asset = project.assets[0];
    asset.shape = Prism{{rectangle(scale * Vec2(-2.0, -1.0), scale * Vec2(2.0, 1.0)), {}}, 0.25 * scale};
    const double mortar = 0.02 * scale, aside = 0.005 * scale;
    asset.pattern =
        test::patternOf(project, {Slices{.cuts = columns - 1, .offsetVariation = 0.0, .angleVariation = 0.0},
                                  BrickBond{.bond = BondKind::Stack,
                                            .length = 4.0 * scale / columns - mortar,
                                            .height = scale - mortar,
                                            .mortar = mortar,
                                            .origin = {aside - 2.0 * scale, -scale}}});
    project.instances[0].pose.position = {0.0, scale, 0.0};
    return project;
}

}  // namespace

class SplittingTest : public QObject {
    Q_OBJECT
private slots:
    void smallIslandsFallApart() {
        Project project = test::bondedWall();
        for (const std::uint32_t least : {1u, 1000u}) {
            project.assets[0].bonding.minimumIsland = least;
            Session session = test::sessionOf(project);
            test::addInput(session, ShotInput{"ball", test::ballAtWall({1.7, 2.7})});
            for (int k = 0; k < 120; ++k) session.step();
            const bool hasIslands = std::ranges::any_of(
                session.bodies(), [](const PlayBody& body) { return body.isDebris() && body.nodes.size() > 1; });
            if (least > 1) QVERIFY(!hasIslands);
        }
    }
    void wallThatLosesItsFootFalls() {
        Project project = test::bondedWall(40);
        Session session = test::sessionOf(project);
        const PlayStructure& structure = *session.scene().structures.begin()->second;
        InstanceDamage damage = session.damage().begin()->second;
        for (std::uint32_t k = 0; k < structure.graph.bondCount(); ++k) {
            damage.broken[k] = structure.graph.bonds[k].second == kNone;
        }
        QVERIFY(session.apply({{project.instances[0].id, damage}}).hasValue());
        QVERIFY(!test::wallOf(session).isHeld);
        QVERIFY(session.world().kind(test::wallOf(session).body) == BodyKind::Dynamic);
        QCOMPARE(session.bodies().size(), std::size_t{2});
    }
    void fixedWallInTheAirKeepsItsHeaviestIsland() {
        Project project = test::bondedWall(40);
        project.instances[0].isAnchored = false;
        project.instances[0].isFixed = true;
        project.instances[0].pose.position.y = 10.0;
        Session session = test::sessionOf(project);
        QVERIFY(test::wallOf(session).isHeld);
        Throw thrown = test::ballAtWall({0.0, 0.0}, 80.0, 20.0);
        thrown.from.y = thrown.to.y = 10.3;
        test::addInput(session, ShotInput{"ball", thrown});
        for (int k = 0; k < 120; ++k) session.step();
        QVERIFY(test::wallOf(session).isHeld);
        QVERIFY2(test::wallOf(session).nodes.size() > 20 && session.bodies().size() > 3,
                 QByteArray::number(test::wallOf(session).nodes.size()));
    }
    void freePartsOfWhatIsFixedInTheAirAreNotHeld() {
        Project project = test::bondedWall(60);
        project.instances[0].isAnchored = false;
        project.instances[0].isFixed = true;
        project.instances[0].pose.position.y = 20.0;
        Session session = test::sessionOf(project);
        for (const double x : {-1.5, 0.0, 1.5}) {
            test::addInput(session, ShotInput{"blast", Blast{.at = {x, 20.0, 0.5}, .impulse = 900.0, .radius = 1.5}});
            for (int k = 0; k < 10; ++k) session.step();
        }
        QVERIFY(session.bodies().size() > 5);
        for (const PlayBody& body : session.bodies()) QVERIFY(!body.isHeld || body.number == 1);
    }
    /// Thrown and placed bodies come apart where only bonds without strength join them, deeper levels when they come
    /// off.
    void whatNothingJoinsIsApart() {
        Project project = test::bondedWall(12);
        project.assets[0].bonding.heightStrengths = {{.height = 0.0, .factor = 0.0}};
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 3}})}};
        Session session = test::sessionOf(project);
        QVERIFY(session.events().splits.empty() && session.damage().begin()->second.isIntact());
        const std::size_t placed = session.bodies().size();
        QVERIFY(placed > 30);
        for (const PlayBody& body : session.bodies()) QVERIFY(!body.isHeld && body.bondedFracture() == nullptr);
        Throw thrown = test::ballAtWall();
        thrown.kind = ProjectileKind::Asset;
        thrown.asset = project.assets[0].id;
        thrown.from.z = 8.0;
        test::addInput(session, ShotInput{"wall", thrown});
        session.step();
        QCOMPARE(session.bodies().size(), 2 * placed - 1);
    }
    void whatNoBondJoinsIsApart_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<unsigned>("columns");
        QTest::newRow("two columns") << 1.0 << 2u;
        QTest::newRow("many columns") << 1.0 << 9u;
        QTest::newRow("small") << 0.2 << 4u;
        QTest::newRow("large") << 20.0 << 5u;
    }
    /// Where the mortar of bricks parts fragments that have no common face, they do not wait for a hit.
    void whatNoBondJoinsIsApart() {
        QFETCH(double, scale);
        QFETCH(unsigned, columns);
        for (const bool isHeld : {true, false}) {
            Project project = columnsOfBricks(scale, columns);
            project.instances[0].isAnchored = isHeld;
            Session session = test::sessionOf(project);
            QVERIFY(session.events().splits.empty() && session.damage().begin()->second.isIntact());
            std::size_t bricks = 0, parts = 0;
            for (const PlayBody& body : session.bodies()) {
                if (body.asset == nullptr) continue;
                QCOMPARE(body.nodes.size(), std::size_t{2});
                QCOMPARE(body.isHeld, isHeld);
                bricks += body.nodes.size();
                ++parts;
            }
            QCOMPARE(parts, std::size_t{columns});
            QCOMPARE(bricks, session.scene().structures.begin()->second->graph.centres.size());
            for (int k = 0; k < 30; ++k) {
                session.step();
                QVERIFY(session.events().splits.empty() && session.events().breaks.empty());
            }
        }
    }
    /// Without restitution the ball and all that came off within its radius have one speed afterwards.
    void whatIsPushedOutMovesAsOne_data() {
        QTest::addColumn<double>("scale");
        QTest::newRow("of stone") << 1.0;
        QTest::newRow("lighter than 1 kg") << 1e-4;
    }
    void whatIsPushedOutMovesAsOne() {
        QFETCH(double, scale);
        Project project = test::bondedWall(300, 100.0 * scale);
        project.materials[0].density *= scale;
        project.materials[0].restitution = 0.0;
        Session session = test::sessionOf(project);
        Throw thrown = test::ballAtWall({0.0, 1.8}, 150.0 * scale);
        thrown.size = Vec3(1.0);
        test::addInput(session, ShotInput{"ball", thrown});
        while (session.events().splits.empty() && session.stepsDone() < 60) session.step();
        std::vector<EnergyEntry> entries;
        std::ranges::copy_if(session.events().energy, std::back_inserter(entries),
                             [](const EnergyEntry& entry) { return entry.change == EnergyChange::Bonds; });
        double pushed = 0.0;  // kg
        for (const std::uint32_t number : session.events().splits.front().freed)
            pushed += session.world().mass(session.body(number)->body);
        QVERIFY(entries.size() > 1 && pushed > 0.1 * thrown.mass);
        const double left = entries[0].after;  // by what the bonds took
        QVERIFY(std::abs(entries[1].before / left - 1.0) < 1e-6);
        const double ratio = entries[1].after / left;
        QVERIFY2(std::abs(ratio - thrown.mass / (thrown.mass + pushed)) < 1e-3, QByteArray::number(ratio));
    }
    /// The numbers of the bodies that came off, not that of a free body itself.
    void freedBodiesAreThoseThatCameOff() {
        for (const bool isHeld : {true, false}) {
            Project project = test::bondedWall(30);
            project.instances[0].isAnchored = isHeld;
            Session session = test::sessionOf(project);
            test::addInput(session, BreakInput{1});
            session.step();
            std::vector<std::uint32_t> expected;
            if (isHeld) expected.push_back(1);
            for (const PlayBody& body : session.events().born) expected.push_back(body.number);
            std::ranges::sort(expected);
            QCOMPARE(session.events().splits.size(), std::size_t{1});
            QCOMPARE(session.events().splits.front().freed, expected);
        }
    }
    void fragmentsBreakFurtherByTheirLevel() {
        Project project = test::bondedWall(12);
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 6}})}};
        Session session = test::sessionOf(project);
        test::addInput(session, BreakInput{1});
        session.step();
        const auto found = std::ranges::find_if(session.bodies(),
                                                [](const PlayBody& body) { return body.bondedFracture() != nullptr; });
        QVERIFY(found != session.bodies().end());
        const std::uint32_t number = found->number, fragment = found->fragment;
        QVERIFY(fragment != kNone && found->nodes.empty());
        test::addInput(session, BreakInput{number});
        session.step();
        const PlayBody& kept = *session.body(number);
        QVERIFY(kept.fragment != fragment && kept.nodes.empty());
        QCOMPARE(session.scene().assets.begin()->second->bake->fragment(kept.fragment).parent, fragment);
        QCOMPARE(kept.asset->bake->fragment(kept.fragment).level, 1u);
    }
};

RUBBLE_TEST(SplittingTest)
#include "SplittingTest.moc"
