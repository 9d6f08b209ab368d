#pragma once

#include "core/play/breaking/BrokenBonds.h"

#include <span>
#include <vector>

namespace rubble {

/// Splits bodies whose bonds have broken into their islands, in the given order: the heaviest island keeps the body's
/// number, those with anchors stay in place, the others move as they did in the body. Where bonds broke, islands with
/// fewer nodes than PlayStructure::minimumIsland fall apart. What has lost its support loses all of its bonds at once,
/// or in a later step, see PlayStructure::collapseDelay; clusters come off as one, where none of their fragments has
/// support. What comes off a held body within the impactor's bounding radius of the point that was hit is pushed
/// together: the hole guides it, where its parts would jam if they were pushed one by one. Then the same for the mortar
/// that holds no longer, see brokenMortar(), and for what is unjoined, see splitUnjoined(). True if any body came free.
bool splitBodies(SessionParts& parts, std::vector<BrokenBonds> broken);

/// Splits the bodies some of whose fragments no bond with a strength joins to the others: those placed at the start of
/// a session, and what has been thrown. splitBodies() does so to what comes off.
void splitUnjoined(SessionParts& parts);

/// Takes nodes, ascending, out of a body with bonds, and splits what is left of it as splitBodies() does, but lets what
/// has lost its support come off at once. Without any node left, the body is gone.
void removeNodes(SessionParts& parts, std::uint32_t body, std::span<const std::uint32_t> nodes);

}  // namespace rubble
