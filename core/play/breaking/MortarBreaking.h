#pragma once

#include "core/play/breaking/BrokenBonds.h"

#include <set>
#include <vector>

namespace rubble {

/// Damages the other halves of the mortar of a structure, by its index in SessionState::structures, as much as its own.
/// What is broken is left to brokenMortar().
void shareMortarDamage(SessionParts& parts, std::uint32_t structure);

/// Breaks the mortar that holds no longer, see looseMortar(). Returns the bodies of which it was, to be split.
/// `changed`: the instances at which something broke or was removed since the last call.
std::vector<BrokenBonds> brokenMortar(SessionParts& parts, const std::set<Id>& changed);

}  // namespace rubble
