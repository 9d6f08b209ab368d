#pragma once

#include "core/play/scene/PlayMortar.h"
#include "core/play/state/SessionState.h"

#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// Nodes of bodies, ascending, by the number of the body.
using UnsupportedNodes = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// The nodes of held bodies in some groups of instances that have lost their support: see supportFractions(), with the
/// limits of joinedSupportLimits(). O(n log n) in the nodes that stood on what broke since the last call, and their
/// bonds, and O(1) for each damaged bond and each body; in all nodes of the groups while gravity does not point as at
/// the start. The first call for a group copies its SupportSpread. Nothing where none of the structures has a span.
UnsupportedNodes unsupportedByMortar(SessionParts& parts, const JoinedGroups& groups);

}  // namespace rubble
