#pragma once

#include "core/base/Index.h"
#include "core/geometry/polygon/IndexedCorners.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// Two parts of a polygon's boundary that touch or cross without being adjacent.
struct BoundaryContact {
    enum class Kind {
        CornersMeet,   // corners `first` and `second` are equal
        CornerOnEdge,  // corner `first` lies in the interior of edge `second`
        EdgesCross,    // edges `first` and `second` cross in their interiors
    };
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    Kind kind = Kind::CornersMeet;
    auto operator<=>(const BoundaryContact&) const = default;
};

/// The contacts and the nesting of the rings of a polygon.
struct RingArrangement {
    std::vector<BoundaryContact> contacts;  // sorted, each once
    std::vector<std::uint32_t> parent;      // the ring directly around each ring, kNone if there is none;
                                            // empty if there are contacts
    bool hasEdgeIntersection = false;       // whether two edges share more than one end; exact for any `maxContacts`
    std::size_t comparisons = 0;            // of two edges: a measure of the work that does not depend on the machine
};
/// Computes the arrangement of rings by a sweep line. Points must be finite, and consecutive points different.
/// Overlapping edges are reported as CornerOnEdge or CornersMeet at their ends. Decided exactly.
///
/// Finds all contacts if there are at most `maxContacts`, otherwise at least one. O(n log n + maxContacts · n).
/// Source: Shamos, Hoey 1976. An edge that intersects another is removed from the sweep and compared with all others
/// afterwards.
RingArrangement ringArrangement(const IndexedCorners& corners, std::size_t maxContacts);

}  // namespace rubble
