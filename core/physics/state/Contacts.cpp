#include "core/physics/state/Contacts.h"

#include "core/base/Assert.h"

#include <cstddef>
#include <utility>

namespace rubble {
namespace {

std::uint32_t nextFreeContact(const WorldState& state) {
    return state.freeContacts.empty() ? static_cast<std::uint32_t>(state.contacts.size()) : state.freeContacts.back();
}

Contact& allocateContact(WorldState& state) {
    if (state.freeContacts.empty()) return state.contacts.emplace_back();
    Contact& contact = state.contacts[state.freeContacts.back()];
    state.freeContacts.pop_back();
    return contact = {};
}

bool isDynamic(const WorldState& state, const Contact& record, int side) {
    return state.bodies[record.bodies[static_cast<std::size_t>(side)]].isDynamic();
}

void freeSlot(WorldState& state, Contact& record) {
    const ContactSlot slot = std::exchange(record.slot, {});
    const std::uint32_t moved = state.colours.remove(slot, isDynamic(state, record, 0), isDynamic(state, record, 1));
    if (moved != kNone) state.contacts[moved].slot = slot;
}

void assignSlot(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    Contact& record = state.contacts[contact];
    record.slot = state.colours.add(contact, record.bodies[0], isDynamic(state, record, 0), record.bodies[1],
                                    isDynamic(state, record, 1), pointCount);
}

}  // namespace

std::uint32_t addContact(WorldState& state, std::uint32_t firstProxy, std::uint32_t secondProxy) {
    RUBBLE_ASSERT(state.proxies[firstProxy].body != state.proxies[secondProxy].body);
    if (secondProxy < firstProxy) std::swap(firstProxy, secondProxy);
    const std::uint32_t contact = nextFreeContact(state);
    if (!state.pairs.insert(firstProxy, secondProxy, contact)) return kNone;
    Contact& record = allocateContact(state);
    record.proxies = {firstProxy, secondProxy};
    record.bodies = {state.proxies[firstProxy].body, state.proxies[secondProxy].body};
    linkContact(state, contact, 0);
    linkContact(state, contact, 1);
    addSeparated(state, contact);
    return contact;
}

void removeContact(WorldState& state, std::uint32_t contact) {
    RUBBLE_ASSERT(state.contacts[contact].stored == kNone);  // its bodies must be woken first
    if (state.contacts[contact].slot.isSet()) endTouching(state, contact);
    removeSeparated(state, contact);
    unlinkContact(state, contact, 0);
    unlinkContact(state, contact, 1);
    Contact& record = state.contacts[contact];
    state.pairs.erase(record.proxies[0], record.proxies[1]);
    record.proxies = {kNone, kNone};
    state.freeContacts.push_back(contact);
}

void beginTouching(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    RUBBLE_ASSERT(!state.contacts[contact].slot.isSet() && state.isAwake(state.contacts[contact]));
    const std::array<std::uint32_t, 2> bodies = state.contacts[contact].bodies;
    removeSeparated(state, contact);
    assignSlot(state, contact, pointCount);
    state.events.began.push_back({state.idOf(bodies[0]), state.idOf(bodies[1])});
}

void moveLane(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    Contact& record = state.contacts[contact];
    RUBBLE_ASSERT(record.slot.isSet());
    if (!ContactColours::isMisplaced(record.slot, pointCount)) return;
    const ContactSlot before = record.slot;
    const std::uint32_t moved = state.colours.moveToOtherList(record.slot);
    if (moved != kNone) state.contacts[moved].slot = before;
}

void endTouching(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    RUBBLE_ASSERT(record.slot.isSet());
    freeSlot(state, record);
    record.features = {};
    addSeparated(state, contact);
    state.events.ended.push_back({state.idOf(record.bodies[0]), state.idOf(record.bodies[1])});
}

void addSeparated(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    if (record.separatedIndex != kNone) return;
    record.separatedIndex = static_cast<std::uint32_t>(state.separated.size());
    state.separated.push_back({contact, record.bodies});
}

void removeSeparated(WorldState& state, std::uint32_t contact) {
    const std::uint32_t index = std::exchange(state.contacts[contact].separatedIndex, kNone);
    if (index == kNone) return;
    const SeparatedContact last = state.separated.back();
    state.separated.pop_back();
    if (last.contact == contact) return;
    state.separated[index] = last;
    state.contacts[last.contact].separatedIndex = index;
}

void invalidateGaps(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
        const std::uint32_t index = state.contacts[contact].separatedIndex;
        if (index != kNone) state.separated[index].apart = kNeverCollided;
    });
}

void forgetPredictions(WorldState& state) {
    state.predictions.assign(state.bodies.size(), {});
    state.obstacleSizes.assign(state.bodies.size(), kStands);
    for (std::size_t body = 0; body < state.bodies.size() && body < state.poses.size(); ++body)
        state.predictions[body] = {state.poses[body].centre, state.poses[body].arc};
    for (SeparatedContact& contact : state.separated) contact.apart = kNeverCollided;
}

void linkContact(WorldState& state, std::uint32_t contact, std::uint32_t side) {
    Contact& record = state.contacts[contact];
    Body& body = state.bodies[record.bodies[side]];
    record.previous[side] = kNone;
    record.next[side] = body.firstContact;
    const std::uint32_t key = 2 * contact + side;
    if (body.firstContact != kNone) state.contacts[body.firstContact / 2].previous[body.firstContact % 2] = key;
    body.firstContact = key;
}

void unlinkContact(WorldState& state, std::uint32_t contact, std::uint32_t side) {
    const Contact& record = state.contacts[contact];
    const std::uint32_t next = record.next[side], previous = record.previous[side];
    if (next != kNone) state.contacts[next / 2].previous[next % 2] = previous;
    if (previous != kNone) {
        state.contacts[previous / 2].next[previous % 2] = next;
    } else {
        state.bodies[record.bodies[side]].firstContact = next;
    }
}

StoredContact takeLane(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    RUBBLE_ASSERT(record.slot.isSet());
    const int lane = ContactColours::laneOf(record.slot);
    const StoredContact taken{storedLane(state.colours.block(record.slot), lane),
                              storedLane(state.colours.reference(record.slot), lane)};
    freeSlot(state, record);
    return taken;
}

void returnLane(WorldState& state, std::uint32_t contact, const StoredContact& stored) {
    Contact& record = state.contacts[contact];
    // The point count is one of the stored words.
    assignSlot(state, contact, stored.block[offsetof(ContactBlock, pointCount) / sizeof(IndexRow)]);
    ContactBlock& block = state.colours.block(record.slot);
    const int lane = ContactColours::laneOf(record.slot);
    const auto index = static_cast<std::size_t>(lane);
    const float againstFixed = block.againstFixed[index];
    putLane(block, lane, stored.block);
    putLane(state.colours.reference(record.slot), lane, stored.reference);
    block.first[index] = record.bodies[0];
    block.second[index] = record.bodies[1];
    block.againstFixed[index] = againstFixed;
}

void storeContact(WorldState& state, std::uint32_t contact) {
    RUBBLE_ASSERT(state.contacts[contact].stored == kNone);
    if (state.freeStored.empty()) {
        state.freeStored.push_back(static_cast<std::uint32_t>(state.stored.size()));
        state.stored.emplace_back();
    }
    const std::uint32_t stored = state.contacts[contact].stored = state.freeStored.back();
    state.freeStored.pop_back();
    state.stored[stored] = takeLane(state, contact);
}

void restoreContact(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    RUBBLE_ASSERT(record.stored != kNone);
    returnLane(state, contact, state.stored[record.stored]);
    state.freeStored.push_back(std::exchange(record.stored, kNone));
}

}  // namespace rubble
