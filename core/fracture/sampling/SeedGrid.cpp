#include "core/fracture/sampling/SeedGrid.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Cells of one row are adjacent in memory, so that a neighbourhood is three runs.
std::size_t bucketOf(std::int64_t column, std::int64_t row, std::size_t buckets) {
    return static_cast<std::size_t>(column + row * 0x9e3779b1) & (buckets - 1);
}

}  // namespace

SeedGrid::SeedGrid(const Box2& box, double minimumDistance)
    : m_origin(box.min),
      m_distanceSquared(minimumDistance * minimumDistance),
      m_cellSide(std::max(minimumDistance, box.diagonal() * 0x1p-30)),  // cell numbers stay exact
      m_heads(64, kNone) {}

std::uint32_t& SeedGrid::headOf(std::int64_t column, std::int64_t row) {
    return m_heads[bucketOf(column, row, m_heads.size())];
}
std::uint32_t SeedGrid::headOf(std::int64_t column, std::int64_t row) const {
    return m_heads[bucketOf(column, row, m_heads.size())];
}

void SeedGrid::add(Vec2 point) {
    if (m_points.size() >= m_heads.size()) grow();
    const Vec2 cell = glm::floor((point - m_origin) / m_cellSide);
    std::uint32_t& head = headOf(static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y));
    m_next.push_back(head);
    head = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(point);
}

void SeedGrid::grow() {
    std::vector<Vec2> points;
    points.swap(m_points);
    m_next.clear();
    m_heads.assign(m_heads.size() * 4, kNone);
    m_points.reserve(m_heads.size());
    for (const Vec2 point : points) add(point);
}

template <class Predicate>
bool SeedGrid::anyNear(Vec2 position, Predicate&& predicate) const {
    const Vec2 cell = glm::floor((position - m_origin) / m_cellSide);
    const std::int64_t column = static_cast<std::int64_t>(cell.x);
    const std::int64_t row = static_cast<std::int64_t>(cell.y);
    for (std::int64_t y = row - 1; y <= row + 1; ++y) {
        for (std::int64_t x = column - 1; x <= column + 1; ++x) {
            for (std::uint32_t at = headOf(x, y); at != kNone; at = m_next[at]) {
                if (predicate(m_points[at])) return true;
            }
        }
    }
    return false;
}

bool SeedGrid::isFree(Vec2 point) const {
    return !anyNear(point, [&](Vec2 other) { return squaredLength(point - other) < m_distanceSquared; });
}

bool SeedGrid::isCovered(Vec2 squareMin, double side) const {
    const Vec2 half{side / 2.0, side / 2.0};
    if (squaredLength(half) >= m_distanceSquared) return false;
    return anyNear(squareMin + half, [&](Vec2 other) {
        return squaredLength(glm::abs(squareMin + half - other) + half) < m_distanceSquared;
    });
}

}  // namespace rubble
