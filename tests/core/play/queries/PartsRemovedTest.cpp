// Tests core/play/queries/PartsRemoved.cpp and, with bonded bodies, core/play/queries/WouldFall.cpp.
#include "core/play/queries/PartsRemoved.h"

#include "core/base/Random.h"
#include "core/play/queries/WouldFall.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/MortarPortal.h"

#include <numeric>
#include <set>

using namespace rubble;

namespace {

using FragmentSet = std::set<std::uint32_t>;

const PlayStructure& structureOf(const Session& session) { return *session.scene().structures.begin()->second; }

bool isIn(const Box3& box, Vec3 point) { return glm::clamp(point, box.min, box.max) == point; }

/// The fragments of the wall whose centres are in a box, in its frame.
std::vector<std::uint32_t> fragmentsIn(const Session& session, const Box3& box) {
    const PlayStructure& structure = structureOf(session);
    std::vector<std::uint32_t> fragments;
    for (std::uint32_t node = 0; node < structure.nodeCount(); ++node) {
        if (isIn(box, structure.graph.centres[node])) fragments.push_back(structure.fragmentOf(node));
    }
    return fragments;
}

constexpr Box3 kLeftPierBox{{-2.0, -1.25, -1.0}, {-1.5, 0.75, 1.0}};
constexpr Box3 kRightPier{{1.5, -1.25, -1.0}, {2.0, 0.75, 1.0}};

Collapse collapseWithout(const Session& session, std::vector<BodyPart> removed) {
    Result<Collapse> collapse = wouldFall(session, removed);
    if (!collapse) qFatal("%s", collapse.error().message.c_str());
    return std::move(*collapse);
}

/// The fragments of the wall that are said to fall.
FragmentSet fallingOf(const Collapse& collapse) {
    FragmentSet falling;
    for (const FallingIsland& island : collapse.islands) {
        for (const BodyPart& part : island.parts) falling.insert(part.fragments.begin(), part.fragments.end());
    }
    return falling;
}

FragmentSet heldFragments(const Session& session) {
    FragmentSet held;
    for (const PlayBody& body : session.bodies()) {
        if (!body.isHeld) continue;
        const std::vector<std::uint32_t> fragments = bondedFragments(body);
        held.insert(fragments.begin(), fragments.end());
    }
    return held;
}

double massOf(const Session& session, const FragmentSet& fragments) {
    const PlayAsset& asset = *structureOf(session).asset;
    double mass = 0.0;
    for (const std::uint32_t fragment : fragments) mass += 2000.0 * asset.fragments[fragment].shape->mass.volume;
    return mass;
}

/// Breaks all bonds of fragments of the wall, and those that `isBroken` says.
template <class IsBroken>
void breakBonds(Session& session, std::span<const std::uint32_t> fragments, const IsBroken& isBroken) {
    const auto& [id, structure] = *session.scene().structures.begin();
    InstanceDamage damage = session.damage().at(id);
    const auto isLost = [&, wall = structure.get()](std::uint32_t node) {
        return node != kNone && std::ranges::binary_search(fragments, wall->fragmentOf(node));
    };
    for (std::uint32_t k = 0; k < structure->graph.bondCount(); ++k) {
        const Bond& bond = structure->graph.bonds[k];
        if (isLost(bond.first) || isLost(bond.second) || isBroken(k)) damage.broken[k] = true;
    }
    if (const Status applied = session.apply({{id, damage}}); !applied) qFatal("%s", applied.error().message.c_str());
}

/// The fragments that are held now, and not if others are gone, by a flood fill from the anchors over unbroken bonds.
FragmentSet floodFill(const Session& session, std::span<const std::uint32_t> removed) {
    const PlayStructure& structure = structureOf(session);
    const std::vector<bool> broken = session.damage().begin()->second.broken;
    const auto isGone = [&](std::uint32_t node) {
        return std::ranges::binary_search(removed, structure.fragmentOf(node));
    };
    std::set<std::uint32_t> reached;
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (std::uint32_t k = 0; k < structure.graph.bondCount(); ++k) {
            const auto& [first, second] = std::pair(structure.graph.bonds[k].first, structure.graph.bonds[k].second);
            if (broken[k] || isGone(first) || (second != kNone && isGone(second))) continue;
            const bool isReached = second == kNone || reached.contains(first) || reached.contains(second);
            if (!isReached) continue;
            isChanged |= reached.insert(first).second;
            if (second != kNone) isChanged |= reached.insert(second).second;
        }
    }
    FragmentSet falling;
    for (const std::uint32_t fragment : heldFragments(session)) {
        const bool isRemoved = std::ranges::binary_search(removed, fragment);
        if (!isRemoved && !reached.contains(fragment - structure.fracture().first)) falling.insert(fragment);
    }
    return falling;
}

std::vector<std::uint32_t> randomFragments(const Session& session, Random& random, std::uint64_t most) {
    const FragmentSet all = heldFragments(session);
    std::set<std::uint32_t> some;
    for (std::uint64_t count = 1 + random.below(most); count > 0; --count)
        some.insert(*std::next(all.begin(), static_cast<std::ptrdiff_t>(random.below(all.size()))));
    return {some.begin(), some.end()};
}

/// Fragments of any held bodies, as parts of these.
std::vector<BodyPart> partsOf(const Session& session, std::span<const std::uint32_t> fragments) {
    std::vector<BodyPart> parts;
    for (const PlayBody& body : session.bodies()) {
        BodyPart part{.body = body.number};
        if (body.isHeld) std::ranges::set_intersection(bondedFragments(body), fragments, back_inserter(part.fragments));
        if (!part.fragments.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace

class PartsRemovedTest : public QObject {
    Q_OBJECT
private slots:
    void lintelFallsWithoutBothPiersAndStandsOnOne() {
        const Session session = test::sessionOf(test::bondedPortal(0.0, 0.0));
        const std::vector<std::uint32_t> left = fragmentsIn(session, kLeftPierBox);
        std::vector<std::uint32_t> both = fragmentsIn(session, kRightPier);
        QVERIFY(left.size() > 4 && both.size() > 4);
        QVERIFY(fallingOf(collapseWithout(session, {{1, left}})).empty());
        both.insert(both.end(), left.begin(), left.end());
        const Collapse collapse = collapseWithout(session, {{1, both}});
        FragmentSet lintel;
        for (const std::uint32_t fragment : heldFragments(session)) {
            if (std::ranges::find(both, fragment) == both.end()) lintel.insert(fragment);
        }
        QCOMPARE(collapse.islands.size(), std::size_t{1});
        QVERIFY(collapse.islands[0].bodies.empty());
        QVERIFY(fallingOf(collapse) == lintel);
        QVERIFY(std::abs(collapse.mass / massOf(session, lintel) - 1.0) < 1e-5);
        QCOMPARE(collapse.islands[0].mass, collapse.mass);
        // Fragments have no straight lower edge: the lowest corner of the lintel is between 1.2 and 2 m up.
        QVERIFY(collapse.first > std::sqrt(2.0 * 1.2 / 9.81) && collapse.first < std::sqrt(2.0 * 2.0 / 9.81));
        QCOMPARE(collapse.first, collapse.last);
    }
    void whatIsBeyondTheSpanFallsAsInPlay() {
        for (const double delay : {0.0, 0.25}) {
            Project project = test::bondedPortal(1.5, delay);
            project.assets[0].bonding.impulsePerArea = 1e9;  // what falls breaks nothing
            Session session = test::sessionOf(project);
            const std::vector<std::uint32_t> pier = fragmentsIn(session, kLeftPierBox);
            const FragmentSet before = heldFragments(session),
                              falling = fallingOf(collapseWithout(session, {{1, pier}}));
            breakBonds(session, pier, [](std::uint32_t) { return false; });
            for (int k = 0; k < 30; ++k) session.step();
            FragmentSet fell;
            std::ranges::set_difference(before, heldFragments(session), std::inserter(fell, fell.end()));
            for (const std::uint32_t fragment : pier) fell.erase(fragment);
            QVERIFY2(falling == fell && falling.size() > 5, QByteArray::number(falling.size()));
        }
    }
    void whatLiesOnAFallingPartFallsToo() {
        Project project = test::bondedPortal(0.0, 0.0);
        const Id stone = project.materials[0].id;
        const Id block = test::addAsset(
            project,
            {.name = "block", .material = stone, .shape = Prism{{rectangle({-0.2, -0.2}, {0.2, 0.2}), {}}, 0.2}},
            {UniformScatter{.count = 2}});
        test::addInstance(project, block, "on the lintel", {.position = {0.0, 2.7, 0.0}});
        test::addInstance(project, block, "beside", {.position = {5.0, 0.2, 0.0}});
        Session session = test::sessionOf(project);
        for (int k = 0; k < 60; ++k) session.step();
        std::vector<std::uint32_t> piers = fragmentsIn(session, kLeftPierBox);
        std::ranges::copy(fragmentsIn(session, kRightPier), std::back_inserter(piers));
        const Collapse collapse = collapseWithout(session, {{1, piers}});
        QCOMPARE(collapse.islands.size(), std::size_t{1});
        QVERIFY(collapse.islands[0].bodies == std::vector<std::uint32_t>{2});
        QCOMPARE(collapse.islands[0].parts.size(), std::size_t{1});
        QVERIFY(std::abs(collapse.mass - massOf(session, fallingOf(collapse)) - 2000.0 * 0.4 * 0.4 * 0.2) < 0.1);
    }
    void bodyThatNothingHoldsIsSimulated() {
        Project project = test::bondedPortal(0.0, 0.0);
        project.instances[0].isAnchored = false;
        Session session = test::sessionOf(project);
        for (int k = 0; k < 120; ++k) session.step();
        QVERIFY(!session.body(1)->isHeld);
        const std::vector<std::uint32_t> pier = fragmentsIn(session, kLeftPierBox);
        const FragmentSet falling = fallingOf(collapseWithout(session, {{1, pier}}));
        QCOMPARE(falling.size(), structureOf(session).nodeCount() - pier.size());  // it tips over
        const Box3 top{{-2.0, 1.0, -1.0}, {-1.5, 1.25, 1.0}};
        QVERIFY(!fragmentsIn(session, top).empty());
        QVERIFY(fallingOf(collapseWithout(session, {{1, fragmentsIn(session, top)}})).empty());
    }
    /// Anchors are to places: play keeps a wall whose fixed support breaks or is removed.
    void heldBodyStaysWithoutTheBodyBelow() {
        Project project = test::bondedWall(40);
        project.ground.isOn = false;
        const Id stone = project.materials[0].id;
        const Id plinth = test::addAsset(
            project,
            {.name = "plinth", .material = stone, .shape = Prism{{rectangle({-2.0, -0.5}, {2.0, 0.0}), {}}, 1.0}},
            {UniformScatter{.count = 4}});
        test::addInstance(project, plinth, "plinth", {.position = {0.0, 0.0, 0.0}});
        project.instances[1].isFixed = true;
        Session session = test::sessionOf(project);
        const auto plinthNumber = session.bodies()[1].number, wallNumber = session.bodies()[0].number;
        QVERIFY(session.body(wallNumber)->isHeld);
        QVERIFY(wouldFall(session, std::array{plinthNumber})->islands.empty());
        test::addInput(session, BreakInput{plinthNumber});
        for (int k = 0; k < 60; ++k) session.step();
        QVERIFY(session.body(plinthNumber) == nullptr && session.body(wallNumber)->isHeld);
    }
    void allFragmentsAreTheWholeBody() {
        const Session session = test::sessionOf(test::bondedWall(40));
        QVERIFY(collapseWithout(session, {{1, bondedFragments(*session.body(1))}}).islands.empty());
        QVERIFY(collapseWithout(session, {{1, {3}}, {1, {}}}).islands.empty());
    }
    void unknownFragmentsAreRefused() {
        Project project = test::bondedWall(40);
        project.instances[0].isUnbreakable = true;
        const Session solid = test::sessionOf(project), session = test::sessionOf(test::bondedWall(40));
        const std::vector<BodyPart> none{{1, {40}}}, first{{1, {0}}};
        QCOMPARE(wouldFall(session, none).error().message,
                 "Cannot remove fragment 40 of \"wall\": it is not bonded in it.");
        QCOMPARE(wouldFall(solid, first).error().message,
                 "Cannot remove fragment 0 of \"wall\": it is not bonded in it.");
    }
    void sessionIsNotTouched() {
        Session session = test::sessionOf(test::bondedPortal(1.5, 0.25)),
                alone = test::sessionOf(test::bondedPortal(1.5, 0.25));
        QVERIFY(!collapseWithout(session, {{1, fragmentsIn(session, kLeftPierBox)}}).islands.empty());
        QVERIFY(session.body(1)->nodes.empty() && session.damage().begin()->second.isIntact());
        for (int k = 0; k < 10; ++k) session.step(), alone.step();
        QVERIFY(session.hash() == alone.hash());
    }

    /// Random fragments of randomly damaged walls, against a flood fill and against play.
    void agreesWithFloodFillAndPlay() {
        constexpr std::uint64_t kSeed = 11;
        qInfo("random seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        std::size_t fallen = 0, splits = 0;
        for (int k = 0; k < 40; ++k) {
            Project project = test::bondedWall(120, 1e9);
            project.assets[0].bonding.span = k % 2 == 0 ? 0.0 : random.between(0.3, 2.0);
            project.assets[0].bonding.collapseDelay = 0.0;
            Session session = test::sessionOf(project);
            const std::uint64_t percent = random.below(60);
            breakBonds(session, {}, [&](std::uint32_t) { return random.below(100) < percent; });
            splits += session.bodies().size() > 2;
            if (heldFragments(session).empty()) continue;
            const std::vector<std::uint32_t> removed = randomFragments(session, random, 30);
            const FragmentSet before = heldFragments(session);
            const FragmentSet falling = fallingOf(collapseWithout(session, partsOf(session, removed)));
            if (k % 2 == 0) QVERIFY2(falling == floodFill(session, removed), QByteArray::number(k));
            breakBonds(session, removed, [](std::uint32_t) { return false; });
            FragmentSet fell;
            std::ranges::set_difference(before, heldFragments(session), std::inserter(fell, fell.end()));
            for (const std::uint32_t fragment : removed) fell.erase(fragment);
            QVERIFY2(falling == fell, QByteArray::number(k));
            fallen += fell.size();
        }
        qInfo("%d fragments fell, %d walls were split before", static_cast<int>(fallen), static_cast<int>(splits));
        QVERIFY(fallen > 200 && splits > 10);
    }
    /// The beam hangs on either pier by its mortar.
    void mortarToWhatIsRemovedBreaks() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        const Session session = Session::start(scene, {}).value();
        const BodyPart left{.body = 1}, right{.body = 2};
        QVERIFY(collapseWithout(session, {left}).islands.empty());
        const Collapse collapse = collapseWithout(session, {left, right});
        QCOMPARE(collapse.islands.size(), 1u);
        QCOMPARE(collapse.islands[0].bodies, std::vector<std::uint32_t>{3});
        QVERIFY(std::abs(collapse.mass - 8000.0) < 1e-6);
        QVERIFY(std::abs(collapse.first - std::sqrt(2.0 * 3.0 / 9.81)) < 0.01);
    }
    void mortarOfRemovedFragmentsBreaks() {
        const auto scene = test::playSceneOf(test::mortarPortal());
        const Session session = Session::start(scene, {}).value();
        std::vector<BodyPart> tops;
        for (const std::uint32_t number : {1u, 2u}) {
            const PlayStructure& pier = *scene->structures.at(scene->project.instances[number - 1].id);
            FragmentSet top;
            for (std::uint32_t bond = pier.firstMortar(); bond < pier.graph.bondCount(); ++bond)
                top.insert(pier.fragmentOf(pier.graph.bonds[bond].first));
            tops.push_back({number, {top.begin(), top.end()}});
        }
        QVERIFY(collapseWithout(session, {tops[0]}).islands.empty());
        const Collapse collapse = collapseWithout(session, tops);
        QCOMPARE(collapse.islands.size(), 1u);
        QCOMPARE(collapse.islands[0].bodies, std::vector<std::uint32_t>{3});
    }
    /// Of a beam with a short span, the part over the removed pier is reported as fragments.
    void spanOfJoinedInstancesIsCounted() {
        Project project = test::mortarPortal();
        project.assets[1].bonding.span = 0.6;
        const auto scene = test::playSceneOf(project);
        Session session = Session::start(scene, {}).value();
        const Collapse collapse = collapseWithout(session, {{.body = 1}});
        const FragmentSet falling = fallingOf(collapse);
        QVERIFY(!falling.empty());
        const PlayStructure& beam = *scene->structures.at(project.instances[2].id);
        QVERIFY(falling.size() < beam.nodeCount());
        for (const std::uint32_t fragment : falling) QVERIFY(beam.graph.centres[fragment - beam.fragmentOf(0)].x < 0.6);
        test::addInput(session, BreakInput{1});
        for (int k = 0; k < 15; ++k) session.step();  // a little more than the delay
        FragmentSet held;
        for (const PlayBody& body : session.bodies()) {
            if (body.origin != session.body(3)->origin || !body.isHeld) continue;
            const std::vector<std::uint32_t> fragments = bondedFragments(body);
            held.insert(fragments.begin(), fragments.end());
        }
        for (std::uint32_t node = 0; node < beam.nodeCount(); ++node)
            QVERIFY(held.contains(beam.fragmentOf(node)) != falling.contains(beam.fragmentOf(node)));
    }
};

RUBBLE_TEST(PartsRemovedTest)
#include "PartsRemovedTest.moc"
