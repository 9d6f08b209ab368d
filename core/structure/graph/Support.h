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

/// The length of a step from a node over one of its bonds to another node, m: see unsupportedNodes().
double sidewaysStep(const BondGraph& graph, std::uint32_t from, BondLink link, Vec3 up);

/// The nodes that do not reach an anchor within a distance sideways, ascending.
///
/// A node is supported if a path of unbroken bonds leads to it from a node with an unbroken bond to an anchor, and the
/// steps of the path sum to `span` (m; 0: any distance, as Bonding::span) at most. A step is as long as the centres of
/// its nodes are apart perpendicular to `up` (of length 1). Where the next node stands on the last, so that the normal
/// of their bond, towards the next, is within 60 degrees of `up`, it is shorter by the sideways part of a rise at 30
/// degrees from `up`, 0 at least: masonry corbels out so far. So a column stands on its lowest node though it leans,
/// and a lintel whose middle is more than the span from its supports does not.
///
/// `nodes`: ascending; paths stay among them. `damage`: of each bond. O(n log n) in the nodes and their bonds.
/// Source: Dijkstra 1959, by (distance, node).
std::vector<std::uint32_t> unsupportedNodes(const BondGraph& graph, std::span<const BondDamage> damage,
                                            std::span<const std::uint32_t> nodes, double span, Vec3 up);

}  // namespace rubble
