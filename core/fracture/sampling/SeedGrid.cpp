#include "core/fracture/sampling/SeedGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rubble {

template <class Vec>
PointGrid<Vec>::PointGrid(Vec min, Vec max, double minimumDistance)
    : m_origin(min),
      m_distanceSquared(minimumDistance * minimumDistance),
      m_cellSide(std::max(minimumDistance, glm::length(max - min) * 0x1p-30)),  // cell numbers stay exact
      m_heads(64, kNone) {}

template <class Vec>
typename PointGrid<Vec>::Cell PointGrid<Vec>::cellOf(Vec point) const {
    const Vec cell = glm::floor((point - m_origin) / m_cellSide);
    Cell numbers{};
    for (int axis = 0; axis < Vec::length(); ++axis)
        numbers[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(cell[axis]);
    return numbers;
}

/// Cells of one row are adjacent in memory, so that a neighbourhood is a few runs.
template <class Vec>
std::size_t PointGrid<Vec>::bucketOf(const Cell& cell) const {
    const auto& [column, row, layer] = cell;
    return static_cast<std::size_t>(column + row * 0x9e3779b1 + layer * 0x85ebca6b) & (m_heads.size() - 1);
}

template <class Vec>
void PointGrid<Vec>::add(Vec point) {
    if (m_points.size() >= m_heads.size()) grow();
    std::uint32_t& head = m_heads[bucketOf(cellOf(point))];
    m_next.push_back(head);
    head = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(point);
}

template <class Vec>
void PointGrid<Vec>::grow() {
    std::vector<Vec> points;
    points.swap(m_points);
    m_next.clear();
    m_heads.assign(m_heads.size() * 4, kNone);
    m_points.reserve(m_heads.size());
    for (const Vec point : points) add(point);
}

template <class Vec>
template <class Predicate>
bool PointGrid<Vec>::anyNear(Vec position, Predicate&& predicate) const {
    const auto [column, row, layer] = cellOf(position);
    constexpr int kLayers = Vec::length() > 2 ? 1 : 0;  // above and below
    for (std::int64_t z = layer - kLayers; z <= layer + kLayers; ++z) {
        for (std::int64_t y = row - 1; y <= row + 1; ++y) {
            for (std::int64_t x = column - 1; x <= column + 1; ++x) {
                for (std::uint32_t at = m_heads[bucketOf({x, y, z})]; at != kNone; at = m_next[at]) {
                    if (predicate(m_points[at])) return true;
                }
            }
        }
    }
    return false;
}

template <class Vec>
bool PointGrid<Vec>::isFree(Vec point) const {
    return !anyNear(point, [&](Vec other) { return glm::dot(point - other, point - other) < m_distanceSquared; });
}

template <class Vec>
bool PointGrid<Vec>::isCovered(Vec squareMin, double side) const {
    const Vec half(side / 2.0);
    if (glm::dot(half, half) >= m_distanceSquared) return false;
    return anyNear(squareMin + half, [&](Vec other) {
        const Vec farthest = glm::abs(squareMin + half - other) + half;
        return glm::dot(farthest, farthest) < m_distanceSquared;
    });
}

template class PointGrid<Vec2>;
template class PointGrid<Vec3>;

}  // namespace rubble
