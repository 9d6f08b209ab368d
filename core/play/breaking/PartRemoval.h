#pragma once

#include "core/play/state/SessionState.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Breaks the mortar of a body.
void breakMortarOf(SessionParts& parts, std::uint32_t number);

/// Takes all bodies of an instance away. Mortar to them breaks, and what reaches no other anchor comes off.
void removeInstance(SessionParts& parts, Id instance);

/// The same for fragments of a bonded instance, with all of their bonds: those that are bonded in a body, or bodies
/// themselves; others are gone.
void removeFragments(SessionParts& parts, Id instance, std::vector<std::uint32_t> fragments);

}  // namespace rubble
