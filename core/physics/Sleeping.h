#pragma once

#include "core/physics/WorldState.h"

namespace rubble {

/// Wakes a dynamic or kinematic body and all that it came to rest with.
void wakeBody(WorldState& state, std::uint32_t body);
/// Wakes what touches a body that sleeps or cannot sleep.
void wakeNeighbours(WorldState& state, std::uint32_t body);
/// Notes whether an awake body rested in a step of dt seconds.
void noteRest(WorldState& state, std::uint32_t body, float dt);
/// Puts to sleep the islands, bodies joined by contacts, all of whose bodies have hardly moved for half a second. Gives the number of islands looked at.
/// Source: Catto 2024, "Simulation Islands"; Tarjan 1975 (union-find).
int sleepWhereAtRest(WorldState& state);
/// As World::islands() says.
std::vector<std::uint32_t> islandsOf(const WorldState& state);

}  // namespace rubble
