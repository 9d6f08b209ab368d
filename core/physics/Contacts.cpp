#include "core/physics/Contacts.h"

#include "core/base/Assert.h"
#include "core/physics/Sleeping.h"

#include <cstddef>
#include <utility>

namespace rubble {
namespace {

void link(WorldState& state, std::uint32_t contact, std::uint32_t side) {
    Contact& record = state.contacts[contact];
    Body& body = state.bodies[record.bodies[side]];
    record.previous[side] = kNone;
    record.next[side] = body.firstContact;
    const std::uint32_t key = 2 * contact + side;
    if (body.firstContact != kNone) state.contacts[body.firstContact / 2].previous[body.firstContact % 2] = key;
    body.firstContact = key;
}

void unlink(WorldState& state, std::uint32_t contact, std::uint32_t side) {
    const Contact& record = state.contacts[contact];
    const std::uint32_t next = record.next[side], previous = record.previous[side];
    if (next != kNone) state.contacts[next / 2].previous[next % 2] = previous;
    if (previous != kNone) {
        state.contacts[previous / 2].next[previous % 2] = next;
    } else {
        state.bodies[record.bodies[side]].firstContact = next;
    }
}

std::uint32_t nextContact(const WorldState& state) {
    return state.freeContacts.empty() ? static_cast<std::uint32_t>(state.contacts.size()) : state.freeContacts.back();
}

Contact& takeNextContact(WorldState& state) {
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
    if (moved != ContactSlot::kNone) state.contacts[moved].slot = slot;
}

void takeSlot(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    Contact& record = state.contacts[contact];
    record.slot = state.colours.add(contact, record.bodies[0], isDynamic(state, record, 0), record.bodies[1],
                                    isDynamic(state, record, 1), pointCount);
}

}  // namespace

std::uint32_t addContact(WorldState& state, std::uint32_t firstProxy, std::uint32_t secondProxy) {
    if (secondProxy < firstProxy) std::swap(firstProxy, secondProxy);
    const std::uint32_t contact = nextContact(state);
    if (!state.pairs.insert(firstProxy, secondProxy, contact)) return kNone;
    Contact& record = takeNextContact(state);
    record.proxies = {firstProxy, secondProxy};
    record.bodies = {state.proxies[firstProxy].body, state.proxies[secondProxy].body};
    link(state, contact, 0);
    link(state, contact, 1);
    listOpen(state, contact);
    return contact;
}

void removeContact(WorldState& state, std::uint32_t contact) {
    RUBBLE_ASSERT(state.contacts[contact].stored == kNone);  // its bodies are woken first
    if (state.contacts[contact].slot.isSet()) endTouching(state, contact);
    unlistOpen(state, contact);
    unlink(state, contact, 0);
    unlink(state, contact, 1);
    Contact& record = state.contacts[contact];
    state.pairs.erase(record.proxies[0], record.proxies[1]);
    record.proxies = {kNone, kNone};
    state.freeContacts.push_back(contact);
}

void beginTouching(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    const std::array<std::uint32_t, 2> bodies = state.contacts[contact].bodies;
    for (std::uint32_t body : bodies) wakeBody(state, body);
    unlistOpen(state, contact);
    takeSlot(state, contact, pointCount);
    state.events.began.push_back({state.idOf(bodies[0]), state.idOf(bodies[1])});
}

void moveLane(WorldState& state, std::uint32_t contact, std::uint32_t pointCount) {
    Contact& record = state.contacts[contact];
    if (!ContactColours::isMisplaced(record.slot, pointCount)) return;
    const ContactSlot left = record.slot;
    const std::uint32_t moved = state.colours.moveToOtherList(record.slot);
    if (moved != ContactSlot::kNone) state.contacts[moved].slot = left;
}

void endTouching(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    freeSlot(state, record);
    record.features = {};
    listOpen(state, contact);
    state.events.ended.push_back({state.idOf(record.bodies[0]), state.idOf(record.bodies[1])});
}

void listOpen(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    if (record.openIndex != kNone) return;
    record.openIndex = static_cast<std::uint32_t>(state.open.size());
    state.open.push_back({contact, record.bodies});
}

void unlistOpen(WorldState& state, std::uint32_t contact) {
    const std::uint32_t place = std::exchange(state.contacts[contact].openIndex, kNone);
    if (place == kNone) return;
    const OpenContact last = state.open.back();
    state.open.pop_back();
    if (last.contact == contact) return;
    state.open[place] = last;
    state.contacts[last.contact].openIndex = place;
}

void storeContact(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    if (state.freeStored.empty()) {
        state.freeStored.push_back(static_cast<std::uint32_t>(state.stored.size()));
        state.stored.emplace_back();
    }
    record.stored = state.freeStored.back();
    state.freeStored.pop_back();
    const int lane = ContactColours::laneOf(record.slot);
    state.stored[record.stored] = {storedLane(state.colours.block(record.slot), lane),
                                   storedLane(state.colours.reference(record.slot), lane)};
    freeSlot(state, record);
}

void bringBackContact(WorldState& state, std::uint32_t contact) {
    Contact& record = state.contacts[contact];
    // How many points it has is one of the words that were stored.
    const std::uint32_t points =
        state.stored[record.stored].block[offsetof(ContactBlock, pointCount) / sizeof(IndexRow)];
    takeSlot(state, contact, points);
    const int lane = ContactColours::laneOf(record.slot);
    putLane(state.colours.block(record.slot), lane, state.stored[record.stored].block);
    putLane(state.colours.reference(record.slot), lane, state.stored[record.stored].reference);
    state.freeStored.push_back(std::exchange(record.stored, kNone));
}

}  // namespace rubble
