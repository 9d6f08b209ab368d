#pragma once

#include "core/asset/project/Bonding.h"
#include "core/base/Index.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A bond between two fragments of a pack.
struct PackBond {
    std::array<std::uint32_t, 2> fragments{kNone, kNone};  // indices in Pack::fragments, ascending
    double area = 0.0;                                     // m²
    Vec3 centroid{0.0};                                    // m, in the asset's frame
    Vec3 normal{0.0};                                      // of length 1, from the first to the second
    std::optional<double> capacity;                        // N·s, >= 0; none: it never breaks
    std::uint32_t clusterLevel = 0;                        // see clusterLevels()
};

/// The bonds between the fragments of a body.
struct PackFracture {
    std::uint32_t fragment = kNone;  // the body; kNone: the whole
    std::vector<PackBond> bonds;     // ascending fragments
};

/// How a pack breaks along bonds, by the simple rule: see SimpleRule.
struct PackBonding {
    double falloffRadius = 0.0;               // m, > 0
    HitFalloff falloff = HitFalloff::Linear;  //
    double damageFrom = 1.0;                  // in (0, 1]
    double span = 0.0;                        // m, >= 0; 0: any
    double collapseDelay = 0.0;               // s, >= 0
    std::uint32_t minimumIsland = 1;          // fragments, >= 1
    std::string bake;                         // damageHash() in hexadecimal
    std::vector<PackFracture> fractures;      // that of the whole, then ascending fragment
    std::vector<std::uint32_t> anchored;      // fragments of the whole that are held, ascending
};

}  // namespace rubble
