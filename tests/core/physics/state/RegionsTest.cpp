#include "core/physics/state/Regions.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

namespace {

/// Awake dynamic bodies 1 to `count` in a row along an axis, in an order of their own.
WorldState rowOfBodies(std::uint32_t count, int axis) {
    WorldState state;
    for (std::uint32_t body = 1; body <= count; ++body) {
        state.bodies.push_back({.kind = BodyKind::Dynamic, .isAwake = true});
        BodyPose& pose = state.poses.emplace_back();
        pose.centre[axis] = static_cast<float>(body * 37 % count);
        pose.boundingRadius = 0.5f;
        state.motions.emplace_back();
        state.awake.push_back(body);
    }
    state.colours.resizeBodies(state.bodies.size());
    return state;
}

}  // namespace

class RegionsTest : public QObject {
    Q_OBJECT
private slots:
    void everyAwakeBodyIsInOneRegion() {
        const WorldState state = rowOfBodies(100, 0);
        for (const int threads : {1, 2, 3, 16}) {
            Regions regions;
            regions.assignBodies(state, threads);
            QCOMPARE(regions.count(), static_cast<std::size_t>(threads));
            std::set<std::uint32_t> seen;
            for (std::size_t region = 0; region < regions.count(); ++region) {
                const auto bodies = regions.bodies(region);
                QVERIFY(std::is_sorted(bodies.begin(), bodies.end()));
                for (const std::uint32_t body : bodies) QVERIFY(seen.insert(body).second);
            }
            QCOMPARE(seen.size(), std::size_t{100});
        }
    }
    void thereAreSixteenRegionsAtMost() {
        Regions regions;
        regions.assignBodies(rowOfBodies(100, 0), 40);
        QCOMPARE(regions.count(), std::size_t{16});
    }
    /// Two regions of a row are its halves, whatever its axis.
    void regionsAreSplitAcrossTheLongestAxis() {
        for (int axis = 0; axis < 3; ++axis) {
            const WorldState state = rowOfBodies(100, axis);
            Regions regions;
            regions.assignBodies(state, 2);
            QCOMPARE(regions.bodies(0).size(), std::size_t{50});
            for (const std::uint32_t body : regions.bodies(0)) QVERIFY(state.poses[body].centre[axis] < 50.0f);
            for (const std::uint32_t body : regions.bodies(1)) QVERIFY(state.poses[body].centre[axis] >= 50.0f);
        }
    }
    void kinematicBodiesAreInTheFirstRegion() {
        WorldState state = rowOfBodies(100, 0);
        for (const std::uint32_t body : {3u, 77u}) state.bodies[body].kind = BodyKind::Kinematic;
        Regions regions;
        regions.assignBodies(state, 4);
        for (const std::uint32_t body : {3u, 77u}) QVERIFY(std::ranges::count(regions.bodies(0), body) == 1);
    }
    /// Contacts of neighbours in the row: after sorting, those of the lower half come first, and the parts of a list
    /// make up the list.
    void contactsAreSortedByRegion() {
        WorldState state = rowOfBodies(100, 0);
        for (std::uint32_t body = 1; body < 100; ++body) {
            Contact& contact = state.contacts.emplace_back();
            contact.bodies = {body, body + 1};
            contact.slot =
                state.colours.add(static_cast<std::uint32_t>(state.contacts.size() - 1), body, true, body + 1, true, 4);
        }
        Regions regions;
        ThreadPool threads(1);
        regions.assignBodies(state, 2);
        regions.sortContacts(state, threads);
        for (std::size_t list = 0; list < ContactColours::kLists; ++list) {
            const std::span<ContactBlock> blocks = state.colours.lists()[list].blocks;
            const std::span lower = regions.part(list, blocks, 0), upper = regions.part(list, blocks, 1);
            QCOMPARE(lower.size() + upper.size(), blocks.size());
            QVERIFY(lower.empty() || lower.data() == blocks.data());
        }
        for (std::uint32_t number = 0; number < state.contacts.size(); ++number) {
            const ContactSlot slot = state.contacts[number].slot;
            QCOMPARE(state.colours.block(slot).contact[static_cast<std::size_t>(ContactColours::laneOf(slot))], number);
        }
        bool isSorted = true;
        for (const ContactColours::List& list : state.colours.lists()) {
            std::vector<bool> isUpper;
            for (std::uint32_t index = 0; index < list.count; ++index) {
                const std::uint32_t body = list.blocks[index / kBlockLanes].first[index % kBlockLanes];
                isUpper.push_back(state.poses[body].centre.x >= 50.0f);
            }
            isSorted = isSorted && std::is_sorted(isUpper.begin(), isUpper.end());
        }
        QVERIFY(isSorted);
    }
    void blocksOfARegionAreAllVisited() {
        Regions regions;
        regions.assignBodies(rowOfBodies(100, 0), 2);
        for (const std::size_t region : {0u, 1u}) {
            std::vector<std::size_t> visited;
            regions.forEachBlockRange(5, region, [&](IndexRange range) {
                for (std::size_t i = range.begin; i < range.end; ++i) visited.push_back(i);
            });
            const std::vector<std::size_t> forwards{0, 1, 2, 3, 4}, backwards{4, 3, 2, 1, 0};
            QCOMPARE(visited, region == 0 ? backwards : forwards);
        }
    }
    void listsAreClearedAndMerged() {
        std::vector<std::vector<std::uint32_t>> lists{{5, 1}, {4}, {}, {2}};
        QCOMPARE(mergeSorted(lists), (std::vector<std::uint32_t>{1, 2, 4, 5}));
        clearLists(lists, 6);
        QCOMPARE(lists.size(), std::size_t{6});
        clearLists(lists, 2);
        QCOMPARE(lists.size(), std::size_t{6});
        for (const auto& list : lists) QVERIFY(list.empty());
    }
};

RUBBLE_TEST(RegionsTest)
#include "RegionsTest.moc"
