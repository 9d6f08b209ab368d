#pragma once

#include "core/fracture/partition/PieceRings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A straight line.
struct Line {
    Vec2 point{0.0, 0.0};      // m
    Vec2 direction{1.0, 0.0};  // any length but zero
    bool operator==(const Line&) const = default;
};

/// The signed distance of a point from a line, whose direction has unit length: positive on the left.
double signedDistance(const Line& line, Vec2 point);

/// A parallel line, with a direction of unit length, that keeps clear of the corners of a piece: moved by about 2^-40
/// of the piece's bounding radius if it is too close to one.
Line clearOfCorners(const PieceRings& piece, std::span<const Vec2> points, Line line);

/// The parts of a piece cut along chords: from the first to the second crossing, from the third to the fourth, and so
/// on. The crossings are corners of the piece. Ordered by their smallest corner (x, then y). The new edges name `piece`
/// as their neighbour.
std::vector<PieceRings> splitAlongChords(const PieceRings& rings, std::uint32_t piece,
                                         std::span<const std::uint32_t> crossings, std::span<const Vec2> points);

}  // namespace rubble
