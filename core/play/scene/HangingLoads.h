#pragma once

#include "core/play/scene/PlayScene.h"

#include <vector>

namespace rubble {

/// A fragment that hangs on bonds: on mortar, on other fragments or on an anchor, beside it or above.
struct HangingLoad {
    Id instance = 0;
    std::uint32_t node = 0;  // of its structure
    double load = 0.0;       // N: its weight and what it carries itself
    double strength = 0.0;   // N: what these bonds take, the impulse that breaks them over the contact time
    double mortar = 0.0;     // the fraction of the load that mortar takes
};

/// The loads that hang on bonds before anything is hit, by instance in the project's order, then node. Infinitely
/// strong bonds are left out. None without gravity.
///
/// An estimate: all that anchors hold sinks under its weight as if bonds were springs, as stiff as their area divided
/// by the distance that they span, which gives the force in each. A fragment that gives a tenth of its load or more to
/// what it stands on stands, which needs no bond; others hang. Leverage is left out. O(n^1.5) in the bonds.
std::vector<HangingLoad> hangingLoads(const PlayScene& scene);

}  // namespace rubble
