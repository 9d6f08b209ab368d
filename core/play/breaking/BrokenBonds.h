#pragma once

#include "core/play/state/SessionState.h"

#include <cstdint>
#include <span>
#include <vector>

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

/// The structure of a body with bonds, begun if none of them was damaged before.
StructureState& structureOf(SessionParts& parts, PlayBody& body);

/// The clusters of a body with damaged bonds that hold, whatever broke in this step.
HeldClusters clustersOf(const StructureState& state, const PlayBody& body);

/// The clusters of a body that hold now: for kLevelTime after a break, also all deeper levels than that which broke, so
/// that levels break one after the other. Of a body with damaged bonds.
inline constexpr double kLevelTime = 1.0 / 60.0;  // s
HeldClusters heldClusters(const SessionParts& parts, const PlayBody& body);

/// Breaks the unbroken bonds of nodes that `isBreaking(link)` accepts, and adds them to `broken`.
template <class IsBreaking>
void breakBonds(StructureState& state, std::span<const std::uint32_t> nodes, const IsBreaking& isBreaking,
                std::vector<std::uint32_t>& broken) {
    for (const std::uint32_t node : nodes) {
        for (const BondLink& link : state.structure->graph.linksOf(node)) {
            if (state.damage[link.bond] == kBroken || !isBreaking(link)) continue;
            state.damage[link.bond] = kBroken;
            broken.push_back(link.bond);
        }
    }
}

}  // namespace rubble
