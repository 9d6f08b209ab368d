#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// Adds a contact of two proxies of different bodies, without a manifold. Returns its index, or kNone if it exists.
std::uint32_t addContact(WorldState& state, std::uint32_t firstProxy, std::uint32_t secondProxy);
/// Removes a contact, whose lane must not be stored: wake its bodies first.
void removeContact(WorldState& state, std::uint32_t contact);

/// Assigns a lane to a contact without a manifold, whose bodies must be awake, and adds the event.
void beginTouching(WorldState& state, std::uint32_t contact, std::uint32_t pointCount);
/// Moves the lane of a contact to the list for its new point count.
void moveLane(WorldState& state, std::uint32_t contact, std::uint32_t pointCount);
/// Frees the lane of a contact, adds it to the separated contacts and adds the event.
void endTouching(WorldState& state, std::uint32_t contact);

/// Adds a contact without a manifold to the separated contacts, or removes it, as its bodies wake and fall asleep.
void addSeparated(WorldState& state, std::uint32_t contact);
void removeSeparated(WorldState& state, std::uint32_t contact);
/// Has the separated contacts of a body collided again, whatever its bodies have travelled since: what they can do in a
/// step has changed.
void invalidateGaps(WorldState& state, std::uint32_t body);
/// The same for all bodies, of a state that was saved without what was predicted for the next step.
void forgetPredictions(WorldState& state);
/// Stores the lane of a contact while its bodies sleep, and restores it.
void storeContact(WorldState& state, std::uint32_t contact);
void restoreContact(WorldState& state, std::uint32_t contact);

/// Links a contact to the contacts of the body on a side (0 or 1), or unlinks it.
void linkContact(WorldState& state, std::uint32_t contact, std::uint32_t side);
void unlinkContact(WorldState& state, std::uint32_t contact, std::uint32_t side);
/// Takes the lane of a contact out of the colours, and returns it for the contact's present bodies. No events.
StoredContact takeLane(WorldState& state, std::uint32_t contact);
void returnLane(WorldState& state, std::uint32_t contact, const StoredContact& lane);

/// Calls visit(contact, other body) for each contact of a body. `visit` may remove the contact.
template <class Visit>
void visitContacts(const WorldState& state, std::uint32_t body, const Visit& visit) {
    for (std::uint32_t key = state.bodies[body].firstContact; key != kNone;) {
        const std::uint32_t contact = key / 2, side = key % 2;
        key = state.contacts[contact].next[side];
        visit(contact, state.contacts[contact].bodies[1 - side]);
    }
}

}  // namespace rubble
