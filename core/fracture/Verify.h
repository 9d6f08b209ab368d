#pragma once

#include "core/fracture/Delaunay.h"
#include "core/fracture/Fragment.h"
#include "core/fracture/Partition.h"
#include "core/fracture/SmallPieces.h"
#include "core/geometry/Polygon.h"

#include <optional>
#include <span>
#include <string>

namespace rubble {

/// Each says in one sentence, with indices and values, what is wrong first, or nothing where all is well.

/// Twins agree, every triangle is counter-clockwise, every edge is locally Delaunay (exact, ties by lowest index),
/// every seed is a site or a duplicate, the ghosts form one convex hull.
std::optional<std::string> verifyDelaunay(const Delaunay& delaunay, std::span<const Vec2> seeds);

/// Every edge has its reverse in the piece named by `across` or lies on the outline, whose own points are all there; no
/// ring meets itself, no points cut a piece apart; rings have area and their right winding; areas sum to the outline's
/// less the gap (relative 1e-9).
std::optional<std::string> verifyPartition(const Partition& partition, const Polygon& outline);

/// Every corner of a piece, and so every point of it, since cells are convex, is nearest to the piece's own seed
/// (relative 1e-9 of the pieces' diameter), against all seeds: O(corners · log seeds), expected.
std::optional<std::string> verifyNearestSeed(const Partition& partition, std::span<const Vec2> seeds);

/// Pieces and fragments name each other; hulls pass verifyPolytope and fill their piece; volumes sum to the prism's less
/// the gap; bonds are mutual; centres of mass are origins. Looks into the partition: verify that before.
std::optional<std::string> verifyFragments(const Fragments& fragments, const Prism& prism);

/// No piece is below the limit, but where it is the only one; parts of 1e-9 of it are rounding.
std::optional<std::string> verifyNoSmallPieces(const Partition& partition, const SmallPieces& small, double depth);

/// What a gap (m; 0: none) leaves of each piece lies within it, and no corner or middle of a side over a cut edge is nearer to it
/// than half the gap (relative 1e-9 of the outline's diameter). Looks into the partition: verify that before.
std::optional<std::string> verifyGap(const Fragments& fragments, double gap);

}  // namespace rubble
