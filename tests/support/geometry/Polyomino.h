#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace rubble {

/// A set of unit lattice cells, for polygons that touch themselves at points.
class Polyomino {
public:
    Polyomino(int width, int height) : m_width(width), m_height(height), m_cells(width * height) {}

    void set(int x, int y, bool isSet) { m_cells[x * m_height + y] = isSet; }
    bool isSet(int x, int y) const {
        return x >= 0 && x < m_width && y >= 0 && y < m_height && m_cells[x * m_height + y];
    }

    /// The union of all set cells that are edge-connected to a cell; every lattice point on its boundary is a corner.
    /// Where it touches itself, the boundary continues around the same cell.
    Polygon componentAt(int x, int y) const {
        const Polyomino component = componentOf(x, y);
        std::map<Edge, bool> open;
        for (int i = 0; i < m_width; ++i)
            for (int j = 0; j < m_height; ++j) component.addBoundary(i, j, open);
        Polygon polygon;
        for (auto& [first, isOpen] : open) {
            Ring ring;
            for (Edge edge = first; open[edge]; edge = following(edge, open)) {
                ring.push_back({edge.x, edge.y});
                open[edge] = false;
            }
            if (ring.empty()) continue;
            if (signedArea(ring) > 0.0)
                polygon.outer = ring;
            else
                polygon.holes.push_back(ring);
        }
        return polygon;
    }

private:
    /// An edge from a lattice point; direction 0 is to the right, then counter-clockwise.
    struct Edge {
        int x, y, direction;
        auto operator<=>(const Edge&) const = default;
    };
    static constexpr std::array<std::array<int, 2>, 4> kStep{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

    Polyomino componentOf(int x, int y) const {
        Polyomino component(m_width, m_height);
        std::vector<std::pair<int, int>> open{{x, y}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (!isSet(i, j) || component.isSet(i, j)) continue;
            component.set(i, j, true);
            for (const auto& step : kStep) open.push_back({i + step[0], j + step[1]});
        }
        return component;
    }
    void addBoundary(int x, int y, std::map<Edge, bool>& open) const {
        if (!isSet(x, y)) return;
        if (!isSet(x, y - 1)) open[{x, y, 0}] = true;
        if (!isSet(x + 1, y)) open[{x + 1, y, 1}] = true;
        if (!isSet(x, y + 1)) open[{x + 1, y + 1, 2}] = true;
        if (!isSet(x - 1, y)) open[{x, y + 1, 3}] = true;
    }
    static Edge following(Edge edge, const std::map<Edge, bool>& all) {
        const int x = edge.x + kStep[edge.direction][0], y = edge.y + kStep[edge.direction][1];
        for (const int turn : {1, 0, 3}) {
            const Edge next{x, y, (edge.direction + turn) % 4};
            if (all.contains(next)) return next;
        }
        return edge;
    }

    int m_width;
    int m_height;
    std::vector<bool> m_cells;
};

}  // namespace rubble
