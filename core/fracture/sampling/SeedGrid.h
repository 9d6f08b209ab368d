#pragma once

#include "core/base/Index.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A spatial hash of points that keep a minimum distance: queries take constant time. Memory depends only on the number
/// of points, however small the distance in a wide box.
class SeedGrid {
public:
    /// For points in or near `box`.
    SeedGrid(const Box2& box, double minimumDistance);

    std::size_t size() const { return m_points.size(); }
    const std::vector<Vec2>& points() const { return m_points; }
    void add(Vec2 point);

    /// Whether no point is closer than the minimum distance.
    bool isFree(Vec2 point) const;
    /// Whether a single point is closer than the minimum distance to all of a square, so that no point of the square is
    /// free.
    bool isCovered(Vec2 squareMin, double side) const;

private:
    template <class Predicate>
    bool anyNear(Vec2 position, Predicate&& predicate) const;
    std::uint32_t& headOf(std::int64_t column, std::int64_t row);
    std::uint32_t headOf(std::int64_t column, std::int64_t row) const;
    void grow();

    Vec2 m_origin;
    double m_distanceSquared;
    double m_cellSide;
    std::vector<Vec2> m_points;
    std::vector<std::uint32_t> m_next;   // in the chain of its cell
    std::vector<std::uint32_t> m_heads;  // of each bucket; their number is a power of two
};

}  // namespace rubble
