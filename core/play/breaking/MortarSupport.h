#pragma once

#include "core/play/state/SessionState.h"

#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// Nodes of bodies, ascending, by the number of the body.
using UnsupportedNodes = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// The nodes of held bodies that mortar joins which have lost their support: see supportFractions(), with the limits
/// of joinedSupportLimits(). O(n log n) in the nodes that mortar joins and their bonds; nothing where none of these
/// structures has a span.
UnsupportedNodes unsupportedByMortar(const SessionParts& parts);

}  // namespace rubble
