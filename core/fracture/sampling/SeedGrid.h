#pragma once

#include "core/base/Index.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/search/Box3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// A spatial hash of points, in the plane or in space, that keep a minimum distance: queries take constant time. Memory
/// depends only on the number of points, however small the distance in a wide box.
template <class Vec>
class PointGrid {
public:
    using Point = Vec;

    /// For points in or near a box.
    PointGrid(Vec min, Vec max, double minimumDistance);

    std::size_t size() const { return m_points.size(); }
    const std::vector<Vec>& points() const { return m_points; }
    void add(Vec point);

    /// Whether no point is closer than the minimum distance.
    bool isFree(Vec point) const;
    /// Whether a single point is closer than the minimum distance to all of a square or cube, so that no point of it is
    /// free.
    bool isCovered(Vec squareMin, double side) const;

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(Vec point) const;
    template <class Predicate>
    bool anyNear(Vec position, Predicate&& predicate) const;
    std::size_t bucketOf(const Cell& cell) const;
    void grow();

    Vec m_origin;
    double m_distanceSquared;
    double m_cellSide;
    std::vector<Vec> m_points;
    std::vector<std::uint32_t> m_next;   // in the chain of its cell
    std::vector<std::uint32_t> m_heads;  // of each bucket; their number is a power of two
};

extern template class PointGrid<Vec2>;
extern template class PointGrid<Vec3>;

/// In the plane.
struct SeedGrid : PointGrid<Vec2> {
    SeedGrid(const Box2& box, double minimumDistance) : PointGrid(box.min, box.max, minimumDistance) {}
};
/// In space.
struct SolidSeedGrid : PointGrid<Vec3> {
    SolidSeedGrid(const Box3& box, double minimumDistance) : PointGrid(box.min, box.max, minimumDistance) {}
};

}  // namespace rubble
