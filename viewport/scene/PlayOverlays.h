#pragma once

#include <cstdint>

namespace rubble {

/// What a moment of play shows beside bodies.
struct PlayOverlays {
    bool hasContacts = false;  // points where bodies touch, red where they overlap by more than kDeepOverlap
    bool hasNormals = false;   // from the first body to the second
    bool hasImpulses = false;  // the longer the stronger: see impulseLength()
    bool hasBoxes = false;     // that the broad phase keeps
    bool hasIslands = false;   // a colour for what hangs together by contacts
    bool hasSleep = false;     // what sleeps is blue
    bool hasHeat = false;      // how near each body is to breaking: see heatColour()
    bool hasHulls = false;     // over the bodies
    bool operator==(const PlayOverlays&) const = default;
};

/// How near a body is to breaking: impact ÷ threshold, at 1 and above it breaks.
struct BodyHeat {
    std::uint32_t body = 0;  // its number
    double value = 0.0;
};

inline constexpr double kDeepOverlap = 0.005;  // m: what a resting contact does not reach

}  // namespace rubble
