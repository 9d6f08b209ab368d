#pragma once

#include "core/geometry/Polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rubble {

/// Finds which straight edges come near a box: squares over the plane, with the edges that pass through each.
class EdgeGrid {
public:
    struct Edge {
        Vec2 from;
        Vec2 to;
    };
    /// Edges that are nearer to something than `margin` are found with it.
    EdgeGrid(const std::vector<Edge>& edges, double margin) : m_margin(margin) {
        double lengths = 0.0;
        for (const Edge& edge : edges) {
            m_box.include(edge.from);
            m_box.include(edge.to);
            lengths += std::abs(edge.to.x - edge.from.x) + std::abs(edge.to.y - edge.from.y);
        }
        if (edges.empty()) return;
        m_box.min -= Vec2(margin);
        m_box.max += Vec2(margin);
        const double count = std::max(static_cast<double>(edges.size()), kLeastSquares);
        const double widest = std::max(m_box.size().x, m_box.size().y);
        // About one square an edge, and where there are many no more than some for each on average.
        m_side =
            std::max({widest / std::ceil(std::sqrt(count)), lengths / (kSquaresOfEdge * count), widest / kMostAlong});
        m_columns = 1 + static_cast<std::int64_t>(m_box.size().x / m_side);
        m_rows = 1 + static_cast<std::int64_t>(m_box.size().y / m_side);
        m_begins.assign(static_cast<std::size_t>(m_columns * m_rows) + 1, 0);
        for (const Edge& edge : edges) forEachSquare(edge, [&](std::size_t square) { ++m_begins[square + 1]; });
        for (std::size_t k = 1; k < m_begins.size(); ++k) m_begins[k] += m_begins[k - 1];
        m_edges.resize(m_begins.back());
        std::vector<std::uint32_t> places(m_begins.begin(), m_begins.end() - 1);
        for (std::uint32_t k = 0; k < edges.size(); ++k) {
            forEachSquare(edges[k], [&](std::size_t square) { m_edges[places[square]++] = k; });
        }
    }

    /// Calls visit(number) for all edges that may come near a straight edge, some of them several times.
    template <class Visit>
    void forEachNear(const Edge& edge, Visit visit) const {
        forEachSquare(edge, [&](std::size_t square) {
            for (std::uint32_t k = m_begins[square]; k < m_begins[square + 1]; ++k) visit(m_edges[k]);
        });
    }

    /// Whether isIt(number) holds for any edge that may come near a box.
    template <class IsIt>
    bool isAnyNear(const Box2& box, IsIt isIt) const {
        if (m_edges.empty()) return false;
        const Span columns = columnsOf(box.min.x, box.max.x), rows = rowsOf(box.min.y, box.max.y);
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            for (std::int64_t column = columns.first; column <= columns.last; ++column) {
                const auto square = static_cast<std::size_t>(row * m_columns + column);
                for (std::uint32_t k = m_begins[square]; k < m_begins[square + 1]; ++k) {
                    if (isIt(m_edges[k])) return true;
                }
            }
        }
        return false;
    }

private:
    static constexpr double kSquaresOfEdge = 4.0;
    static constexpr double kLeastSquares =
        4096.0;  // few edges leave most of the plane empty: it is good to know where
    static constexpr double kMostAlong = 2048.0;

    struct Span {
        std::int64_t first;
        std::int64_t last;
    };
    Span spanOf(double low, double high, double from, std::int64_t count) const {
        const double most = static_cast<double>(count);
        const double first = std::floor((low - m_margin - from) / m_side),
                     last = std::floor((high + m_margin - from) / m_side);
        if (!(last >= 0.0) || !(first < most)) return {0, -1};
        return {static_cast<std::int64_t>(std::max(first, 0.0)), static_cast<std::int64_t>(std::min(last, most - 1.0))};
    }
    Span columnsOf(double low, double high) const { return spanOf(low, high, m_box.min.x, m_columns); }
    Span rowsOf(double low, double high) const { return spanOf(low, high, m_box.min.y, m_rows); }

    /// Row by row, the squares between where the edge enters the row and where it leaves it.
    template <class Visit>
    void forEachSquare(const Edge& edge, Visit visit) const {
        if (m_begins.empty()) return;
        const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
        const Span rows = rowsOf(low, high);
        const bool isLow = edge.from.y == low;
        const Vec2 from = isLow ? edge.from : edge.to, to = isLow ? edge.to : edge.from;
        const double slope = high > low ? (to.x - from.x) / (high - low) : 0.0;
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            double enter = from.x, leave = to.x;
            // Where a level edge enters a row says nothing about where it is in it.
            if (rows.last > rows.first && high - low > kSlack * m_side) {
                const double bottom = m_box.min.y + static_cast<double>(row) * m_side;
                enter = from.x + slope * (std::max(bottom - m_margin, low) - low);
                leave = from.x + slope * (std::min(bottom + m_side + m_margin, high) - low);
            }
            const double slack = kSlack * m_side;
            const Span columns = columnsOf(std::min(enter, leave) - slack, std::max(enter, leave) + slack);
            for (std::int64_t column = columns.first; column <= columns.last; ++column) {
                visit(static_cast<std::size_t>(row * m_columns + column));
            }
        }
    }
    static constexpr double kSlack =
        1e-3;  // of a square: far above what rounding takes from where an edge enters a row

    double m_margin;
    double m_side = 1.0;  // m, of a square
    Box2 m_box;
    std::int64_t m_columns = 0;
    std::int64_t m_rows = 0;
    std::vector<std::uint32_t> m_begins;  // of each square, and one more
    std::vector<std::uint32_t> m_edges;
};

}  // namespace rubble
