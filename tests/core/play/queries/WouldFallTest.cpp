// Tests core/play/queries/WouldFall.cpp and core/play/queries/ContactGraph.cpp.
#include "core/play/queries/WouldFall.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/RestingProjects.h"
#include "tests/support/play/Sessions.h"

#include <cstdio>
#include <limits>
#include <set>

using namespace rubble;

namespace {

std::set<std::uint32_t> numbersOf(const Collapse& collapse) {
    std::set<std::uint32_t> numbers;
    for (const FallingIsland& island : collapse.islands) numbers.insert(island.bodies.begin(), island.bodies.end());
    return numbers;
}

/// A session that goes on from another in which bodies are removed.
Session withoutBodies(const Session& session, std::span<const std::uint32_t> removed) {
    World world({.gravity = session.world().gravity()});
    world.restore(*session.world().snapshot());
    SessionSnapshot snapshot = *session.snapshot();
    for (const std::uint32_t number : removed) {
        world.removeBody(session.body(number)->body);
        std::erase_if(snapshot.state.bodies, [&](const PlayBody& body) { return body.number == number; });
    }
    snapshot.world = world.snapshot();
    // The scene is that of `session`, which lives longer.
    Result<Session> started = Session::start({std::shared_ptr<void>(), &session.scene()});
    if (!started) qFatal("%s", started.error().message.c_str());
    started->restore(snapshot);
    return std::move(*started);
}

void playSeconds(Session& session, double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds / session.stepLength()));
    for (int step = 0; step < steps; ++step) session.step();
}

/// The bodies that move more than 5 cm or 5 % of their size within three seconds, or break.
std::set<std::uint32_t> fallenIn(const Session& session, std::span<const std::uint32_t> removed) {
    Session later = withoutBodies(session, removed);
    playSeconds(later, 3.0);
    std::set<std::uint32_t> fallen;
    for (const PlayBody& body : session.bodies()) {
        if (std::ranges::find(removed, body.number) != removed.end()) continue;
        const PlayBody* now = later.body(body.number);
        const double size = 2.0 * session.world().shape(body.body).boundingRadius;
        const Vec3 before = session.world().state(body.body).centre;
        if (now == nullptr ||
            glm::distance(later.world().state(now->body).centre, before) > std::min(0.05, 0.05 * size)) {
            fallen.insert(body.number);
        }
    }
    return fallen;
}

Session settled(const Project& project) {
    Session session = test::sessionOf(project);
    playSeconds(session, 2.0);
    return session;
}

/// The house at rest after a shot at its wall.
Session ruin() {
    Session session = settled(test::house());
    const Shot& shot = session.scene().project.shots[1];
    test::addInput(session, ShotInput{shot.name, shot.action});
    playSeconds(session, 15.0);
    return session;
}

/// Fragments at rest after all blocks broke and fell.
Session heap() {
    Session session = settled(test::heapProject(8));
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Instance) test::addInput(session, BreakInput{body.number});
    }
    playSeconds(session, 15.0);
    return session;
}

/// One to three random bodies.
std::vector<std::uint32_t> randomBodies(const Session& session, Random& random) {
    std::set<std::uint32_t> numbers;
    for (const std::uint64_t count = 1 + random.below(3); numbers.size() < count;) {
        const PlayBody& body = session.bodies()[random.below(session.bodies().size())];
        if (body.role != PlayRole::Ground) numbers.insert(body.number);
    }
    return {numbers.begin(), numbers.end()};
}

/// How often the query and the simulation say the same.
struct Agreement {
    std::size_t removals = 0;
    std::size_t equal = 0;     // removals in which they agree on every body
    std::size_t bodies = 0;    // in all removals
    std::size_t differ = 0;    // of the bodies
    std::size_t fallen = 0;    // in the simulation
    std::size_t foretold = 0;  // of these

    double ofBodies() const { return 1.0 - static_cast<double>(differ) / static_cast<double>(bodies); }
    void add(const Session& session, const std::set<std::uint32_t>& said, const std::set<std::uint32_t>& fell,
             std::size_t removed) {
        std::vector<std::uint32_t> different;
        std::ranges::set_symmetric_difference(said, fell, std::back_inserter(different));
        ++removals;
        equal += different.empty() ? 1 : 0;
        bodies += session.bodies().size() - 1 - removed;
        differ += different.size();
        fallen += fell.size();
        foretold += static_cast<std::size_t>(
            std::ranges::count_if(fell, [&](std::uint32_t number) { return said.contains(number); }));
    }
    void print(const char* name, const char* effort) const {
        std::printf(
            "%-8s %-8s %3zu removals, %3zu equal in every body; %.2f %% of the bodies; %zu of %zu falls foretold\n",
            name, effort, removals, equal, 100.0 * ofBodies(), foretold, fallen);
    }
};

/// The numbers of the instances at a horizontal place, lowest first.
std::vector<std::uint32_t> stackAt(const Session& session, double x) {
    std::vector<std::uint32_t> numbers;
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Instance) continue;
        if (std::abs(session.world().state(body.body).centre.x - x) < 0.1) numbers.push_back(body.number);
    }
    return numbers;
}

}  // namespace

class WouldFallTest : public QObject {
    Q_OBJECT
private slots:
    void everythingAboveARemovedBlockFalls() {
        const Session session = settled(test::stackProject());
        const std::vector<std::uint32_t> stack = stackAt(session, 2.0);
        const Result<Collapse> collapse = wouldFall(session, std::array{stack[0]});
        QCOMPARE(collapse->islands.size(), 1u);
        QVERIFY(collapse->islands[0].bodies == std::vector(stack.begin() + 1, stack.end()));
        QVERIFY(std::abs(collapse->mass - 4 * 500.0) < 0.1);  // 2000 kg/m³ · 0.25 m³
        QCOMPARE(collapse->islands[0].mass, collapse->mass);
        // The blocks fall 0.5, 1, 1.5 and 2 m onto the ground.
        QVERIFY(std::abs(collapse->first - std::sqrt(2.0 * 0.5 / 9.81)) < 0.01);
        QVERIFY(std::abs(collapse->last - std::sqrt(2.0 * 2.0 / 9.81)) < 0.01);
    }
    void blocksOfTwoStacksAreTwoIslands() {
        const Session session = settled(test::stackProject());
        const std::vector<std::uint32_t> first = stackAt(session, 0.0), third = stackAt(session, 4.0);
        const Result<Collapse> collapse = wouldFall(session, std::array{third[3], first[2]});
        QCOMPARE(collapse->islands.size(), 2u);
        QVERIFY(collapse->islands[0].bodies == std::vector(first.begin() + 3, first.end()));
        QVERIFY(collapse->islands[1].bodies == std::vector{third[4]});
    }
    void nothingFallsWithoutALoadOrGravity() {
        const Session session = settled(test::stackProject());
        const Result<Collapse> collapse = wouldFall(session, std::array{stackAt(session, 2.0).back()});
        QVERIFY(collapse->islands.empty());
        QCOMPARE(collapse->mass, 0.0);
        QCOMPARE(collapse->last, 0.0);
        QVERIFY(wouldFall(session, std::span<const std::uint32_t>())->islands.empty());
        Project weightless = test::stackProject();
        weightless.gravity = Vec3(0.0);
        const Session floating = settled(weightless);
        QVERIFY(wouldFall(floating, std::array{floating.bodies()[1].number})->islands.empty());
    }
    void whatHangsOverNothingFallsForever() {
        Project project = test::blockProject();
        project.ground.isOn = false;
        test::addBlock(project, {0.0, 1.0, 0.0});
        project.instances[0].isFixed = true;
        test::addBlock(project, {0.0, 1.5, 0.0});
        const Session session = settled(project);
        const Result<Collapse> collapse = wouldFall(session, std::array{session.bodies()[0].number});
        QVERIFY(numbersOf(*collapse) == std::set{session.bodies()[1].number});
        QCOMPARE(collapse->last, std::numeric_limits<double>::infinity());
    }
    void sessionIsNotTouched() {
        Session session = settled(test::house()), alone = settled(test::house());
        for (const PlayBody& body : session.bodies()) {
            if (body.role == PlayRole::Instance) QVERIFY(wouldFall(session, std::array{body.number}).hasValue());
        }
        playSeconds(session, 0.5);
        playSeconds(alone, 0.5);
        QVERIFY(session.hash() == alone.hash());
    }
    void bodiesThatDoNotExistAreRefused() {
        const Session session = settled(test::stackProject());
        QCOMPARE(wouldFall(session, std::array{4711u}).error().message, "Cannot remove: there is no body 4711.");
        QCOMPARE(wouldFall(session, std::array{0u}).error().message, "Cannot remove the ground.");
    }

    /// Three hundred random removals, against simulations of three seconds.
    void agreesWithSimulation() {
        constexpr std::uint64_t kSeed = 7;
        const std::vector<std::pair<const char*, Session (*)()>> scenes{
            {"stacks", [] { return settled(test::stackProject()); }},
            {"pyramid", [] { return settled(test::pyramidProject()); }},
            {"portals", [] { return settled(test::portalProject()); }},
            {"arches", [] { return settled(test::archProject()); }},
            {"house", [] { return settled(test::house()); }},
            {"ruin", ruin},
            {"heap", heap}};
        std::printf("random seed %d\n", static_cast<int>(kSeed));
        Random random(kSeed);
        std::size_t equal = 0, removals = 0, quicklyEqual = 0, quickRemovals = 0;
        for (const auto& [name, make] : scenes) {
            const Session session = make();
            Agreement thorough, quick;
            for (int k = 0; k < 43; ++k) {
                const std::vector<std::uint32_t> removed = randomBodies(session, random);
                const std::set<std::uint32_t> fell = fallenIn(session, removed);
                thorough.add(session, numbersOf(*wouldFall(session, removed)), fell, removed.size());
                const Result<Collapse> soon = wouldFall(session, removed, QueryEffort::Quick);
                quick.add(session, numbersOf(*soon), fell, removed.size());
            }
            thorough.print(name, "thorough");
            quick.print(name, "quick");
            // Quick queries see a part of what is connected in the heap of 384, of which any change lets others slide.
            const double least = session.bodies().size() > 200 ? 0.94 : 0.95;
            QVERIFY2(thorough.ofBodies() >= 0.99 && quick.ofBodies() >= least, name);
            equal += thorough.equal;
            removals += thorough.removals;
            if (session.bodies().size() > 200) continue;
            quicklyEqual += quick.equal;
            quickRemovals += quick.removals;
        }
        std::printf("equal in every body: %zu of %zu; by quick queries, up to 200 bodies: %zu of %zu\n", equal,
                    removals, quicklyEqual, quickRemovals);
        QVERIFY(20 * equal >= 19 * removals);
        QVERIFY(20 * quicklyEqual >= 19 * quickRemovals);
    }
};

RUBBLE_TEST(WouldFallTest)
#include "WouldFallTest.moc"
