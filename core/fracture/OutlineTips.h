#pragma once

#include "core/geometry/PointFrame.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The tips of an outline's sharp corners: as far as its two edges are too near to each other for a point on each. All
/// that lies there is one with the corner, else a cell's edge across the tip would take the corner away with it. No
/// longer than kVisiblePart (NarrowPlaces.h) of a validated outline.
class OutlineTips {
public:
    /// Of a canonical outline; vertices are numbered ring by ring.
    OutlineTips(const Polygon& outline, const PointFrame& frame);

    /// Whether no corner is so sharp.
    bool areNone() const { return m_longest == 0.0; }
    bool isSharp(std::uint32_t vertex) const { return m_tips[vertex].length > 0.0; }
    /// Whether a point, relative to the frame, lies in the tip at a vertex.
    bool contain(std::uint32_t vertex, Vec2 point) const { return isSharp(vertex) && isIn(m_tips[vertex], point); }

private:
    struct Tip {
        Vec2 corner{0.0, 0.0};  // relative to the frame
        Vec2 ahead{0.0, 0.0};   // unit vectors along the edges of a sharp corner, the outline's inside between them
        Vec2 back{0.0, 0.0};
        double length = 0.0;  // m; 0: not sharp
    };
    bool isIn(const Tip& tip, Vec2 point) const;
    void addRing(const Ring& ring, const PointFrame& frame);

    double m_joinDistance;
    double m_longest = 0.0;   // m
    std::vector<Tip> m_tips;  // of each vertex
};

}  // namespace rubble
