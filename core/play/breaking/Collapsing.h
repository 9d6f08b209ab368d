#pragma once

#include "core/play/breaking/BrokenBonds.h"

#include <set>

namespace rubble {

/// Breaks the bonds of what has no support among `nodes`, all of a body, but those of its clusters: in one piece it
/// would jam between what stands. Adds them to `broken`. `state`: of the body's structure. Nothing of a body that is
/// not held, or that mortar joins: for that see planMortarCollapse().
void breakUnsupported(const SessionParts& parts, const PlayBody& body, std::span<const std::uint32_t> nodes,
                      const HeldClusters& held, StructureState& state, std::vector<std::uint32_t>& broken);

/// Plans when a held body with damaged bonds loses what has no support, see PlayStructure::collapseDelay; one that has
/// come free does not.
void planCollapse(const SessionParts& parts, PlayBody& body);

/// Plans when the held bodies that mortar joins with some instances, at which something broke in a step or was removed,
/// lose what has no support.
void planMortarCollapse(SessionParts& parts, const std::set<Id>& changed);

/// Breaks the bonds of what lost its support and has to come off in this step. Returns the bodies of which they were,
/// for splitBodies().
std::vector<BrokenBonds> brokenByCollapse(SessionParts& parts);

}  // namespace rubble
