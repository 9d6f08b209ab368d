#pragma once

#include "core/play/state/SessionState.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace rubble {

/// Nodes of bodies, ascending, by the number of the body.
using UnsupportedNodes = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// The nodes of held bodies of some instances, and of what mortar joins with them, which have lost their support: see
/// supportFractions(), with the limits of joinedSupportLimits(). O(n log n) in the nodes of these instances and their
/// bonds; nothing where none of their structures has a span.
UnsupportedNodes unsupportedByMortar(const SessionParts& parts, const std::set<Id>& instances);

}  // namespace rubble
