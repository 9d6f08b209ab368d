#pragma once

#include "core/asset/project/Bonding.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// How a hit breaks bonds; see applyHit().
struct SimpleRule {
    double radius = 0.3;                      // m, > 0
    HitFalloff falloff = HitFalloff::Linear;  //
    double damageFrom = 0.5;                  // in (0, 1]
    bool operator==(const SimpleRule&) const = default;
};
SimpleRule simpleRuleOf(const Bonding& bonding);

/// A hit on a body.
struct BondHit {
    std::span<const Vec3> points;  // m, in the structure's frame; one at least
    double impulse = 0.0;          // N·s, >= 0
    HeldClusters held;             // its bonds that do not break yet
};

/// The effect of a hit. No bond is in both lists.
struct HitOutcome {
    /// The largest load of a bond by all of the impulse, relative to what breaks the bond as it was damaged before: at
    /// least 1 if and only if one broke. Of the bonds that a hit loads, also those that it did not damage.
    double utilization = 0.0;
    double taken = 0.0;                  // N·s, of the hit's, that it took to break and damage bonds
    std::vector<std::uint32_t> broken;   // bonds that broke, ascending
    std::vector<std::uint32_t> damaged;  // bonds with new damage that hold, ascending
};

/// The fraction of a hit's impulse that loads a bond at a distance, m: 1 at 0, nothing beyond the radius.
double loadFraction(const SimpleRule& rule, double distance);

/// Breaks and damages bonds of a body by a hit.
///
/// The fragments that are hit, those whose centres are nearest to its points, give the whole impulse to each of their
/// bonds: any fragment can be broken off. With clusters, so do the other fragments of theirs, and bonds that are
/// held get nothing: any cluster can be broken off, as one. The bonds around them are loaded by their distance from the
/// nearest point, as loadFraction() says. Only unbroken bonds between nodes of `owner`, and from them to anchors,
/// count.
///
/// In order of utilization, impulse * fraction / capacity, largest first, ties by distance, then index, each bond takes
/// from what is left of the impulse J:
///
///     U = J * fraction / capacity                     none below damageFrom
///     increase of damage = 1                          if U >= 1: the bond breaks
///                        = (U - damageFrom) / (1 - damageFrom), rounded down to a multiple of 1/255
///     impulse taken = capacity * increase             of a damaged bond: of what was left of it
///
/// Damage accumulates over hits; at 1 the bond breaks. `capacities`: N·s for each bond, >= 0; infinite: it never
/// breaks. `damage`: of each bond. The result does not depend on the order of bonds but by those ties. O(n) in the
/// nodes, and O(m log m) in the bonds within the radius.
HitOutcome applyHit(const BondGraph& graph, std::span<const double> capacities, const SimpleRule& rule,
                    const BondHit& hit, std::span<const std::uint32_t> ownerOfNode, std::uint32_t owner,
                    std::span<BondDamage> damage);

/// The load of a bond, N·s.
struct BondLoad {
    std::uint32_t bond = 0;
    double load = 0.0;
};

/// Breaks and damages bonds, each by a load of its own, as a blast does: the same as applyHit(), but nothing that one
/// takes is missing to another. `taken` is the sum.
HitOutcome applyLoads(std::span<const double> capacities, const SimpleRule& rule, std::span<const BondLoad> loads,
                      std::span<BondDamage> damage);

/// A hit with a smaller impulse changes nothing, N·s; infinite if no bond can break.
double leastImpulse(std::span<const double> capacities, const SimpleRule& rule);

}  // namespace rubble
