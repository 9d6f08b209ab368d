#pragma once

#include "core/physics/Manifold.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// Makes the contact of two proxies, without manifold, and gives its number; kNone where they have one.
std::uint32_t addContact(WorldState& state, std::uint32_t firstProxy, std::uint32_t secondProxy);
/// Takes it out; what lay on either body wakes where they touched.
void removeContact(WorldState& state, std::uint32_t contact);

/// Gives a contact that has no manifold a lane to keep one of so many points in.
void beginTouching(WorldState& state, std::uint32_t contact, std::uint32_t pointCount);
/// Moves its lane where those of so many points are.
void moveLane(WorldState& state, std::uint32_t contact, std::uint32_t pointCount);
/// Frees its lane and lists it among those without.
void endTouching(WorldState& state, std::uint32_t contact);

/// Lists a contact without manifold, or takes it off, as its bodies wake and sleep.
void listOpen(WorldState& state, std::uint32_t contact);
void unlistOpen(WorldState& state, std::uint32_t contact);
/// Keeps the lane of a contact for when its bodies wake, and brings it back.
void storeContact(WorldState& state, std::uint32_t contact);
void bringBackContact(WorldState& state, std::uint32_t contact);

/// Calls visit(contact, other body) for each contact of a body. The contact may be removed meanwhile.
template <class Visit>
void visitContacts(const WorldState& state, std::uint32_t body, const Visit& visit) {
    for (std::uint32_t key = state.bodies[body].firstContact; key != kNone;) {
        const std::uint32_t contact = key / 2, side = key % 2;
        key = state.contacts[contact].next[side];
        visit(contact, state.contacts[contact].bodies[1 - side]);
    }
}

}  // namespace rubble
