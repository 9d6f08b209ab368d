#pragma once

#include "core/geometry/polygon/HalfPlaneClip.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble::bench {

/// The Voronoi cells of seeds in the unit square, as the other libraries return them: convex, counter-clockwise.
struct Cells {
    std::vector<Vec2> corners;
    std::vector<std::uint32_t> ends;   // one past each cell's last corner
    std::vector<std::uint32_t> seeds;  // of each cell
};

double areaOf(const Cells& cells);

/// Collects cells corner by corner and clips those that leave the square, with the project's own clipper.
class CellWriter {
public:
    explicit CellWriter(std::size_t seeds);

    /// Adds a corner of the current cell, counter-clockwise; it may lie outside the square.
    void addCorner(Vec2 corner) {
        m_leaves = m_leaves || !(corner.x >= 0.0 && corner.x <= 1.0 && corner.y >= 0.0 && corner.y <= 1.0);
        m_cells.corners.push_back(corner);
    }
    /// Ends a bounded cell.
    void endBounded(std::uint32_t seed);
    /// Ends an unbounded cell: it is the square clipped by the bisectors.
    void endUnbounded(std::uint32_t seed, Vec2 site, std::span<const Vec2> neighbours);

    Cells take() { return std::move(m_cells); }

private:
    void clipRing(const HalfPlane& halfPlane);
    void endWithRing(std::uint32_t seed);
    void end(std::uint32_t seed);

    Cells m_cells;
    std::size_t m_first = 0;  // corner of the current cell
    bool m_leaves = false;
    Ring m_ring, m_clipped;
};

}  // namespace rubble::bench
