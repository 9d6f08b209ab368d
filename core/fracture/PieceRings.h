#pragma once

#include "core/geometry/Vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A corner of a piece: the number of its point, and the piece behind the edge that starts at it.
struct PieceCorner {
    std::uint32_t point;
    std::uint32_t across;
};
using PieceRing = std::vector<PieceCorner>;

/// The rings of one piece: the outer one first, then its holes.
using PieceRings = std::vector<PieceRing>;

/// Puts the edges of rings that may meet themselves and each other in points together anew: one entry for each connected
/// part of the area they enclose. Its rings do not meet themselves, and meet each other only in points that do not cut
/// it apart. Rings of fewer than three corners are gone.
std::vector<PieceRings> connectedParts(std::vector<PieceRing> rings, std::span<const Vec2> points);

}  // namespace rubble
