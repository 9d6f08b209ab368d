#pragma once

#include "core/fracture/partition/PointEdge.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// A corner of a piece: its point, and the piece behind the edge that starts there.
struct PieceCorner {
    std::uint32_t point;
    std::uint32_t neighbour;
};
using PieceRing = std::vector<PieceCorner>;

/// The rings of one piece: the outer one first, then its holes.
using PieceRings = std::vector<PieceRing>;

/// An edge of a piece: the one that starts at a corner of a ring.
struct RingEdge {
    std::size_t ring;
    std::size_t corner;
};
/// The corner after another one in its ring.
inline std::size_t nextCorner(const PieceRing& ring, std::size_t corner) {
    return corner + 1 < ring.size() ? corner + 1 : 0;
}
/// An edge of a piece; nothing if there is none between these points. Linear in the corners.
std::optional<RingEdge> findEdge(const PieceRings& rings, PointEdge edge);

/// Rebuilds the rings of an area whose rings may touch themselves and each other at points: one entry for each
/// connected part of the area. Its rings do not touch themselves, and touch each other only at points that do not
/// disconnect it. Rings of fewer than three corners are dropped.
std::vector<PieceRings> connectedParts(std::vector<PieceRing> rings, std::span<const Vec2> points);

}  // namespace rubble
