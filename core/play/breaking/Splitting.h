#pragma once

#include "core/play/state/SessionState.h"

#include <set>
#include <span>

namespace rubble {

/// A body of which bonds have broken, and by what.
struct BrokenBonds {
    std::uint32_t body = 0;            // its number
    std::uint32_t impactor = kNone;    // its number; kNone: none
    double impulse = 0.0;              // N·s, that the bonds took
    double speed = 0.0;                // m/s, of the approach
    double restitution = 0.0;          // of the pair
    Vec3 point{0.0, 0.0, 0.0};         // m, in the world
    Vec3 normal{0.0, 0.0, 0.0};        // from the impactor into the body
    ClusterLevel level = kEveryLevel;  // at which it broke, see heldClusters()
    std::vector<std::uint32_t> bonds;  // all that broke in what was joined, ascending; none: any
};

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

/// The clusters of a body that hold now: for kLevelTime after a break, also all deeper levels than that which broke, so
/// that levels break one after the other. Of a body with damaged bonds.
inline constexpr double kLevelTime = 1.0 / 60.0;  // s
HeldClusters heldClusters(const SessionParts& parts, const PlayBody& body);

/// Breaks the bonds of what lost its support and has to come off in this step. True if any did.
bool collapseUnsupported(SessionParts& parts);

/// Plans when the held bodies that mortar joins with some instances, at which something broke in a step or was removed,
/// lose what has no support.
void planMortarCollapse(SessionParts& parts, const std::set<Id>& changed);

/// Takes nodes, ascending, out of a body with bonds, and splits what is left of it as splitBodies() does, but lets what
/// has lost its support come off at once. Without any node left, the body is gone.
void removeNodes(SessionParts& parts, std::uint32_t body, std::span<const std::uint32_t> nodes);

/// The structure of a body with bonds, begun if none of them was damaged before.
StructureState& structureOf(SessionParts& parts, PlayBody& body);

}  // namespace rubble
