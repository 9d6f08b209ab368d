#pragma once

#include "core/geometry/NumberedCorners.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// Two places of a polygon's boundary that meet though they are not neighbours.
struct BoundaryContact {
    enum class Kind {
        CornersMeet,   // corners `first` and `second` are equal
        CornerOnEdge,  // corner `first` lies inside edge `second`
        EdgesCross,    // edges `first` and `second` cross inside both
    };
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    Kind kind = Kind::CornersMeet;
    auto operator<=>(const BoundaryContact&) const = default;
};

/// How the rings of a polygon lie to themselves and to each other.
struct RingArrangement {
    std::vector<BoundaryContact> contacts;  // ascending, each once
    std::vector<std::uint32_t> parent;      // the ring directly around each ring, kNoRing where there is none;
                                            // empty where there are contacts
    bool doEdgesCollide = false;  // whether two edges have more in common than one end; exact whatever `most` is
};
inline constexpr std::uint32_t kNoRing = 0xffffffffu;

/// Sweeps a line over the edges of rings whose points are finite and whose neighbouring points differ. Edges that lie on each
/// other show as CornerOnEdge or CornersMeet, whichever holds at their ends. Decided exactly.
///
/// All contacts, where there are no more than `most` of them; else at least one. O(n log n + most · n).
/// Source: Shamos, Hoey 1976; an edge that meets another is taken out of the sweep and compared with all
/// others afterwards.
RingArrangement arrangementOf(const NumberedCorners& corners, std::size_t most);

}  // namespace rubble
