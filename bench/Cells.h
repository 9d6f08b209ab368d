#pragma once

#include "core/geometry/HalfPlaneClip.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble::bench {

/// The Voronoi cells of seeds in the unit square as the peers give them: convex, counter-clockwise, one after another.
struct Cells {
    std::vector<Vec2> corners;
    std::vector<std::uint32_t> ends;   // one past each cell's last corner
    std::vector<std::uint32_t> seeds;  // whose cell it is
};

double areaOf(const Cells& cells);

/// Puts cells together from what lies around their seeds. Clips with the project's own clipper, and only where there is
/// something to clip.
class CellWriter {
public:
    explicit CellWriter(std::size_t seeds);

    /// The next corner of the cell under way, counter-clockwise; it may lie outside the square.
    void addCorner(Vec2 corner) {
        m_leaves = m_leaves || !(corner.x >= 0.0 && corner.x <= 1.0 && corner.y >= 0.0 && corner.y <= 1.0);
        m_cells.corners.push_back(corner);
    }
    /// Ends a cell that its corners bound.
    void endBounded(std::uint32_t seed);
    /// Ends a cell that is open or whose corners are not all known: it is what the bisectors leave of the square.
    void endOpen(std::uint32_t seed, Vec2 site, std::span<const Vec2> neighbours);

    Cells take() { return std::move(m_cells); }

private:
    void clipRing(const HalfPlane& halfPlane);
    void endWithRing(std::uint32_t seed);
    void end(std::uint32_t seed);

    Cells m_cells;
    std::size_t m_first = 0;  // corner of the cell under way
    bool m_leaves = false;
    Ring m_ring, m_clipped;
};

}  // namespace rubble::bench
