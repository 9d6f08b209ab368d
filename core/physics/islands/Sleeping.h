#pragma once

#include "core/physics/state/WorldState.h"

#include <cstddef>

namespace rubble {

/// Wakes a dynamic or kinematic body and its sleeping island: something other than a new contact disturbed it. If it is
/// awake, its rest begins again.
void wakeBody(WorldState& state, std::uint32_t body);
/// Wakes both bodies of a new contact, whose half second of rest begins again: what rattles touches others forever.
void wakeBodies(WorldState& state, std::uint32_t contact);
/// Wakes the bodies that touch a body, which itself does not sleep with them.
void wakeNeighbours(WorldState& state, std::uint32_t body);

/// Brings WorldState::awake up to date with the bodies woken and removed since the last call. Waking only appends to a
/// list, so that waking n bodies takes O(n log n), with any number of islands. Returns the number of list elements
/// read.
std::size_t updateAwakeBodies(WorldState& state);

/// Puts islands, bodies connected by contacts, to sleep if each of their bodies is at rest (Rest.h). An island that a
/// moving kinematic body touches, or of which a body is grabbed, stays awake.
/// Returns the number of islands tested.
/// Source: Catto 2024, "Simulation Islands"; Tarjan 1975 (union-find).
int sleepRestingIslands(WorldState& state);
/// Puts all islands to sleep where they are, with the contacts that they have.
void sleepAllIslands(WorldState& state);
/// World::islands().
std::vector<std::uint32_t> islandsOf(const WorldState& state);

}  // namespace rubble
