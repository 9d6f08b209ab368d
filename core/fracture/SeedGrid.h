#pragma once

#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Points that keep a distance from each other, found by place in constant time. Points are chained by the hash of
/// their cell; memory grows with their number alone, however small the distance in a wide box.
class SeedGrid {
public:
    /// For points in or near the box.
    SeedGrid(const Box2& box, double minimumDistance);

    std::size_t size() const { return m_points.size(); }
    const std::vector<Vec2>& points() const { return m_points; }
    void add(Vec2 point);

    /// True where no point is nearer than the minimum distance.
    bool isFree(Vec2 point) const;
    /// True where one point is nearer than the minimum distance to everything in the square, so that it has no room.
    bool isCovered(Vec2 squareMin, double side) const;

private:
    static constexpr std::uint32_t kEnd = 0xffffffffu;
    template <class Predicate>
    bool anyAround(Vec2 place, Predicate&& predicate) const;
    std::uint32_t& headOf(std::int64_t column, std::int64_t row);
    std::uint32_t headOf(std::int64_t column, std::int64_t row) const;
    void enlarge();

    Vec2 m_origin;
    double m_distanceSquared;
    double m_cellSide;
    std::vector<Vec2> m_points;
    std::vector<std::uint32_t> m_next;   // in the chain of its cell
    std::vector<std::uint32_t> m_heads;  // a power of two
};

}  // namespace rubble
