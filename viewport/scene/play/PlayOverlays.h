#pragma once

#include "core/play/scene/PlayBody.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Debug overlays of a scene in play.
struct PlayOverlays {
    bool hasContacts = false;  // contact points, red where bodies overlap by more than kDeepOverlap
    bool hasNormals = false;   // contact normals, from the first body to the second
    bool hasImpulses = false;  // contact impulses: see impulseLength()
    bool hasBoxes = false;     // boxes of the broad phase
    bool hasIslands = false;   // colours bodies by island
    bool hasBodies = false;    // colours each body, which shows the fragments that hold together
    bool hasBonds = false;     // lines between bonded fragments, coloured by damage
    bool hasSleep = false;     // colours sleeping bodies blue
    bool hasHeat = false;      // colours bodies by impact ÷ threshold: see heatColour()
    bool hasHulls = false;     // collision hulls
    bool hasCollapse = false;  // colours the body at the pointer, and what would fall without it, also fragments
    bool operator==(const PlayOverlays&) const = default;
};

/// Impact ÷ threshold of a body; it breaks at 1 and above.
struct BodyHeat {
    std::uint32_t body = 0;  // its number
    double value = 0.0;
};

/// A body or some of its fragments, and what would fall if it were removed.
struct BodyCollapse {
    BodyPart removed;
    std::vector<std::uint32_t> falling;       // numbers, ascending
    std::vector<BodyPart> fallingParts = {};  // of other bodies, ascending

    /// Whether fragments of a body are shown, and not all of it.
    bool hasPartOf(std::uint32_t body) const;
};

inline constexpr double kDeepOverlap = 0.005;  // m: more than resting contacts reach

}  // namespace rubble
