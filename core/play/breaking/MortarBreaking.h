#pragma once

#include "core/play/breaking/Splitting.h"

#include <vector>

namespace rubble {

/// Damages the other halves of the mortar of a structure, by its index in SessionState::structures, as much as its own.
/// What is broken is left to brokenMortar().
void shareMortarDamage(const SessionParts& parts, std::uint32_t structure);

/// Breaks the mortar that holds no longer: whose other half is broken, and that between instances of which none is
/// connected to an anchor any more, directly or through mortar. Returns the bodies of which it was, to be split.
/// O(bonds of the structures that have mortar); nothing where there is none.
std::vector<BrokenBonds> brokenMortar(const SessionParts& parts);

}  // namespace rubble
