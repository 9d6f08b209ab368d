#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rubble {

/// A uniform grid of straight edges: finds those near an edge or a box.
class EdgeGrid {
public:
    struct Edge {
        Vec2 from;
        Vec2 to;
    };
    /// `margin`: the distance, in m, at which edges count as near.
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
        const double count = std::max(static_cast<double>(edges.size()), kMinCells);
        const double widest = std::max(m_box.size().x, m_box.size().y);
        // About one cell per edge, but limited on average for long edges.
        m_side = std::max(
            {widest / std::ceil(std::sqrt(count)), lengths / (kMaxCellsPerEdge * count), widest / kMaxCellsPerSide});
        m_columns = 1 + static_cast<std::int64_t>(m_box.size().x / m_side);
        m_rows = 1 + static_cast<std::int64_t>(m_box.size().y / m_side);
        m_begins.assign(static_cast<std::size_t>(m_columns * m_rows) + 1, 0);
        for (const Edge& edge : edges) forEachCell(edge, [&](std::size_t cell) { ++m_begins[cell + 1]; });
        for (std::size_t k = 1; k < m_begins.size(); ++k) m_begins[k] += m_begins[k - 1];
        m_edges.resize(m_begins.back());
        std::vector<std::uint32_t> places(m_begins.begin(), m_begins.end() - 1);
        for (std::uint32_t k = 0; k < edges.size(); ++k) {
            forEachCell(edges[k], [&](std::size_t cell) { m_edges[places[cell]++] = k; });
        }
    }

    /// Calls visit(index) for all edges that may be near a straight edge, for some of them several times.
    template <class Visit>
    void forEachNear(const Edge& edge, Visit visit) const {
        forEachCell(edge, [&](std::size_t cell) {
            for (std::uint32_t k = m_begins[cell]; k < m_begins[cell + 1]; ++k) visit(m_edges[k]);
        });
    }

    /// Whether predicate(index) is true of any edge that may be near a box.
    template <class Predicate>
    bool isAnyNear(const Box2& box, Predicate predicate) const {
        if (m_edges.empty()) return false;
        const Span columns = columnsOf(box.min.x, box.max.x), rows = rowsOf(box.min.y, box.max.y);
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            for (std::int64_t column = columns.first; column <= columns.last; ++column) {
                const auto cell = static_cast<std::size_t>(row * m_columns + column);
                for (std::uint32_t k = m_begins[cell]; k < m_begins[cell + 1]; ++k) {
                    if (predicate(m_edges[k])) return true;
                }
            }
        }
        return false;
    }

private:
    static constexpr double kMaxCellsPerEdge = 4.0;
    static constexpr double kMinCells = 4096.0;  // with few edges most cells are empty, which is worth knowing
    static constexpr double kMaxCellsPerSide = 2048.0;

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

    /// Visits, row by row, the cells from the point where the edge enters the row to the point where it leaves it.
    template <class Visit>
    void forEachCell(const Edge& edge, Visit visit) const {
        if (m_begins.empty()) return;
        const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
        const Span rows = rowsOf(low, high);
        const bool isLow = edge.from.y == low;
        const Vec2 from = isLow ? edge.from : edge.to, to = isLow ? edge.to : edge.from;
        const double slope = high > low ? (to.x - from.x) / (high - low) : 0.0;
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            double enter = from.x, leave = to.x;
            // An almost horizontal edge may be anywhere in a row.
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
    static constexpr double kSlack = 1e-3;  // of a cell: far above what rounding takes from where an edge enters a row

    double m_margin;
    double m_side = 1.0;  // m, of a cell
    Box2 m_box;
    std::int64_t m_columns = 0;
    std::int64_t m_rows = 0;
    std::vector<std::uint32_t> m_begins;  // of each cell, and one more
    std::vector<std::uint32_t> m_edges;
};

}  // namespace rubble
