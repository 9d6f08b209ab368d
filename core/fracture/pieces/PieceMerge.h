#pragma once

#include "core/fracture/partition/PieceRings.h"

#include <cstdint>
#include <span>

namespace rubble {

/// The rings of the union of some pieces, the outer one first. `group`: ascending pieces that are connected by edges.
/// `receivers`: for each piece, the piece that it is merged into; that of all pieces in the group is the same.
PieceRings mergedRings(std::span<const PieceRings> pieces, std::span<const std::uint32_t> group,
                       std::span<const std::uint32_t> receivers, std::span<const Vec2> points);

}  // namespace rubble
