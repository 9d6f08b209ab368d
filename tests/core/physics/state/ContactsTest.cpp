#include "core/physics/state/Contacts.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

namespace {

/// Dynamic, awake bodies 1, 2, ... with a proxy each, of the same number less one.
WorldState bodies(std::uint32_t count) {
    WorldState state;
    for (std::uint32_t body = 1; body <= count; ++body) {
        state.bodies.push_back({.kind = BodyKind::Dynamic, .isAwake = true});
        state.proxies.push_back({.body = body});
    }
    state.colours.resizeBodies(state.bodies.size());
    return state;
}

/// The contacts of a body, with the other body.
std::set<std::pair<std::uint32_t, std::uint32_t>> contactsOf(const WorldState& state, std::uint32_t body) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> contacts;
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) { contacts.insert({contact, other}); });
    return contacts;
}

std::size_t laneOf(const WorldState& state, std::uint32_t contact) {
    return static_cast<std::size_t>(ContactColours::laneOf(state.contacts[contact].slot));
}
ContactBlock& blockOf(WorldState& state, std::uint32_t contact) {
    return state.colours.block(state.contacts[contact].slot);
}

}  // namespace

class ContactsTest : public QObject {
    Q_OBJECT
private slots:
    void contactIsLinkedToBothBodies() {
        WorldState state = bodies(3);
        const std::uint32_t a = addContact(state, 1, 0), b = addContact(state, 1, 2);
        QVERIFY(state.contacts[a].proxies == (std::array<std::uint32_t, 2>{0, 1}));  // the lower first
        QVERIFY(contactsOf(state, 1) == (std::set<std::pair<std::uint32_t, std::uint32_t>>{{a, 2}}));
        QVERIFY(contactsOf(state, 2) == (std::set<std::pair<std::uint32_t, std::uint32_t>>{{a, 1}, {b, 3}}));
        QCOMPARE(state.separated.size(), std::size_t{2});
        QCOMPARE(addContact(state, 0, 1), kNone);  // it exists
    }
    /// The first, the middle and the last of three are removed in turn.
    void removedContactsAreUnlinked() {
        for (std::size_t gone = 0; gone < 3; ++gone) {
            WorldState state = bodies(4);
            std::vector<std::uint32_t> contacts;
            for (std::uint32_t other = 1; other < 4; ++other) contacts.push_back(addContact(state, 0, other));
            removeContact(state, contacts[gone]);
            std::set<std::pair<std::uint32_t, std::uint32_t>> left;
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (k != gone) left.insert({contacts[k], k + 2});
            }
            QVERIFY(contactsOf(state, 1) == left);
            QVERIFY(contactsOf(state, static_cast<std::uint32_t>(gone) + 2).empty());
            QCOMPARE(state.separated.size(), std::size_t{2});
            for (std::uint32_t k = 0; k < state.separated.size(); ++k) {
                QCOMPARE(state.contacts[state.separated[k].contact].separatedIndex, k);
            }
            // Its place is taken again.
            QCOMPARE(addContact(state, 2, 3), contacts[gone]);
        }
    }
    void visitedContactsMayBeRemoved() {
        WorldState state = bodies(4);
        for (std::uint32_t other = 1; other < 4; ++other) addContact(state, 0, other);
        visitContacts(state, 1, [&](std::uint32_t contact, std::uint32_t) { removeContact(state, contact); });
        QVERIFY(contactsOf(state, 1).empty());
        QVERIFY(state.separated.empty());
    }
    void touchingContactsHaveALaneAndEvents() {
        WorldState state = bodies(2);
        const std::uint32_t contact = addContact(state, 0, 1);
        beginTouching(state, contact, 3);
        QVERIFY(state.contacts[contact].slot.isSet());
        QVERIFY(state.separated.empty());
        QCOMPARE(blockOf(state, contact).contact[laneOf(state, contact)], contact);
        QCOMPARE(state.events.began.size(), std::size_t{1});
        QVERIFY(state.events.began[0].first.index == 1 && state.events.began[0].second.index == 2);
        state.contacts[contact].features = {1, 2, 3, 4};
        endTouching(state, contact);
        QVERIFY(!state.contacts[contact].slot.isSet());
        QCOMPARE(state.separated.size(), std::size_t{1});
        QCOMPARE(state.events.ended.size(), std::size_t{1});
        QCOMPARE(state.contacts[contact].features[0], 0u);
        QCOMPARE(state.colours.contactCount(), std::size_t{0});
    }
    void removalEndsTouching() {
        WorldState state = bodies(2);
        const std::uint32_t contact = addContact(state, 0, 1);
        beginTouching(state, contact, 3);
        removeContact(state, contact);
        QCOMPARE(state.events.ended.size(), std::size_t{1});
        QVERIFY(state.separated.empty());
        QCOMPARE(state.colours.contactCount(), std::size_t{0});
    }
    /// Contacts with one or two points are in the first list of a colour, others in the second.
    void laneMovesWithThePointCount() {
        WorldState state = bodies(4);
        const std::uint32_t a = addContact(state, 0, 1), b = addContact(state, 2, 3);
        beginTouching(state, a, 2);
        beginTouching(state, b, 2);
        blockOf(state, a).friction[laneOf(state, a)] = 0.25f;
        blockOf(state, b).friction[laneOf(state, b)] = 0.75f;
        const ContactSlot before = state.contacts[a].slot;
        moveLane(state, a, 1);
        QCOMPARE(state.contacts[a].slot.list, before.list);
        moveLane(state, a, 3);
        QCOMPARE(state.contacts[a].slot.list, before.list + 1);
        QCOMPARE(blockOf(state, a).friction[laneOf(state, a)], 0.25f);
        QCOMPARE(state.contacts[b].slot.index, 0u);  // moved to where the other was
        QCOMPARE(blockOf(state, b).friction[laneOf(state, b)], 0.75f);
    }
    void lanesAreStoredWhileBodiesSleep() {
        WorldState state = bodies(4);
        const std::uint32_t a = addContact(state, 0, 1), b = addContact(state, 2, 3);
        for (const std::uint32_t contact : {a, b}) {
            beginTouching(state, contact, 4);
            blockOf(state, contact).pointCount[laneOf(state, contact)] = 4;
            blockOf(state, contact).points[2].impulse[laneOf(state, contact)] = contact == a ? 1.5f : 2.5f;
            state.colours.reference(state.contacts[contact].slot).slack[laneOf(state, contact)] =
                contact == a ? 0.5f : 0.75f;
        }
        storeContact(state, a);
        QVERIFY(!state.contacts[a].slot.isSet());
        QCOMPARE(blockOf(state, b).points[2].impulse[laneOf(state, b)], 2.5f);
        storeContact(state, b);
        QVERIFY(state.contacts[a].stored != state.contacts[b].stored);
        QCOMPARE(state.colours.contactCount(), std::size_t{0});
        restoreContact(state, a);
        QCOMPARE(state.contacts[a].stored, kNone);
        QCOMPARE(state.contacts[a].slot.list % 2, 1u);  // four points
        QCOMPARE(blockOf(state, a).points[2].impulse[laneOf(state, a)], 1.5f);
        QCOMPARE(state.colours.reference(state.contacts[a].slot).slack[laneOf(state, a)], 0.5f);
        restoreContact(state, b);
        QCOMPARE(blockOf(state, b).points[2].impulse[laneOf(state, b)], 2.5f);
        QCOMPARE(state.stored.size(), std::size_t{2});
        storeContact(state, a);  // in a place that is free again
        QCOMPARE(state.stored.size(), std::size_t{2});
    }
};

RUBBLE_TEST(ContactsTest)
#include "ContactsTest.moc"
