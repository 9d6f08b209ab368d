#pragma once

#include "core/fracture/partition/PieceRings.h"

#include <cstdint>
#include <span>

namespace rubble {

/// The rings of the union of some pieces, the outer one first. `group`: ascending pieces that are connected by edges.
/// `receivers`: of each piece, the one that it is merged into; the pieces of the group have the same one.
PieceRings mergedRings(std::span<const PieceRings> pieces, std::span<const std::uint32_t> group,
                       std::span<const std::uint32_t> receivers, std::span<const Vec2> points);

}  // namespace rubble
