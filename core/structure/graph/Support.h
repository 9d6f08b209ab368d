#pragma once

#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// What is above a bond stands on what is below if the angle between its normal and up is at most 60 degrees: the
/// cosine of that.
inline constexpr double kStandsOn = 0.5;

/// The length of a step from a node over one of its bonds to another node, m: see anchorDistances().
double sidewaysStep(const BondGraph& graph, std::uint32_t from, BondLink link, Vec3 up);

/// The distance of each node from the nearest anchor, m; infinite where no path of unbroken bonds leads from one.
///
/// A path begins at a node with an unbroken bond to an anchor, and its steps sum to the distance. A step is as long as
/// the centres of its nodes are apart perpendicular to `up` (of length 1). Where the next node stands on the last, so
/// that the normal of their bond, towards the next, is within 60 degrees of `up`, it is shorter by the sideways part of
/// a rise at 30 degrees from `up`, 0 at least: masonry corbels out so far. So a column stands on its lowest node though
/// it leans. `damage`: of each bond. O(n log n) in the nodes and their bonds.
/// Source: Dijkstra 1959, by (distance, node).
std::vector<double> anchorDistances(const BondGraph& graph, std::span<const BondDamage> damage, Vec3 up);

/// The distance from an anchor up to which each node of a structure is supported, m: the span (0: any), or the
/// distance with the damage at the start where that is larger. So what is beyond the span from the start keeps the
/// support that it has.
std::vector<double> supportLimits(const BondGraph& graph, std::span<const BondDamage> atStart, double span, Vec3 up);

/// The nodes that have lost their support, ascending: those farther from an anchor than their limit, over paths of
/// supported nodes. So a lintel whose middle is more than the span from its supports loses it.
///
/// `nodes`: ascending; paths stay among them. `limits`: of each node of the graph, see supportLimits(). Distances and
/// complexity as of anchorDistances().
std::vector<std::uint32_t> unsupportedNodes(const BondGraph& graph, std::span<const BondDamage> damage,
                                            std::span<const std::uint32_t> nodes, std::span<const double> limits,
                                            Vec3 up);

}  // namespace rubble
