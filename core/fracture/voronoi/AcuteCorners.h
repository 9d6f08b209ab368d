#pragma once

#include "core/geometry/polygon/LocalFrame.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The acute corner regions of an outline: the tip of an acute corner, where its two edges are closer than two distinct
/// points can be. Every point there is welded to the corner; otherwise a cell edge that crosses the tip would remove
/// the corner. No longer than kVisibleFraction (NarrowFeatures.h) of a validated outline.
class AcuteCorners {
public:
    /// `outline` is canonical; vertices are numbered ring by ring.
    AcuteCorners(const Polygon& outline, const LocalFrame& frame);

    /// Whether the outline has no acute corner.
    bool isEmpty() const { return m_longest == 0.0; }
    bool isAcute(std::uint32_t vertex) const { return m_regions[vertex].length > 0.0; }
    /// Whether a point, relative to the frame, lies in the region of a vertex.
    bool contain(std::uint32_t vertex, Vec2 point) const { return isAcute(vertex) && isIn(m_regions[vertex], point); }

private:
    struct Region {
        Vec2 corner{0.0, 0.0};  // relative to the frame
        Vec2 ahead{0.0, 0.0};   // unit vectors along the two edges, with the inside between them
        Vec2 back{0.0, 0.0};
        double length = 0.0;  // m; 0: not acute
    };
    bool isIn(const Region& region, Vec2 point) const;
    void addRing(const Ring& ring, const LocalFrame& frame);

    double m_weldDistance;
    double m_longest = 0.0;         // m
    std::vector<Region> m_regions;  // of each vertex
};

}  // namespace rubble
