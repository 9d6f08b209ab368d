#pragma once

#include "core/play/state/SessionState.h"

#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// Nodes of bodies, ascending, by the number of the body.
using UnsupportedNodes = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// The nodes without support of held bodies that mortar joins. Support spreads from the anchors that are none of
/// mortar, as in unsupportedNodes(), with each distance as a fraction of the span of the structure that it is in. Over
/// mortar it goes on to what stands on a node, which has all of its span from there; and sideways, with what is left of
/// the span. What lies above a node does not support it: it would be held by what it carries. A structure without a
/// span is supported where it is held.
///
/// O(n log n) in the nodes that mortar joins and their bonds; nothing where none of these structures has a span.
UnsupportedNodes unsupportedByMortar(const SessionParts& parts);

}  // namespace rubble
