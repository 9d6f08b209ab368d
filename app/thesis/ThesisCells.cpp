#include "app/thesis/ThesisCells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

/// Returns the seeds that share a triangle with a seed, ascending.
std::vector<std::uint32_t> neighboursOf(std::uint32_t seed, const ThesisDiagram& diagram) {
    std::vector<std::uint32_t> others;
    for (const auto& triangle : diagram.triangles) {
        if (std::find(triangle.begin(), triangle.end(), seed) == triangle.end()) continue;
        for (const std::uint32_t other : triangle) {
            if (other != seed) others.push_back(other);
        }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    return others;
}

bool isCell(const Ring& ring) {
    return ring.size() >= 3 && std::all_of(ring.begin(), ring.end(), [](Vec2 corner) {
               return std::isfinite(corner.x) && std::isfinite(corner.y);
           });
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Triangles as triangleList() gives them.
Triangles inOrder(Triangles triangles, std::span<const Vec2> seeds) {
    for (auto& [a, b, c] : triangles) {
        if (cross(seeds[b] - seeds[a], seeds[c] - seeds[a]) < 0.0) std::swap(b, c);
    }
    for (auto& triangle : triangles) {
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace

std::vector<Cell> thesisCells(const ThesisDiagram& diagram) {
    std::vector<Cell> cells;
    for (std::uint32_t seed = 0; seed < diagram.cells.size(); ++seed) {
        if (!isCell(diagram.cells[seed])) continue;
        Cell& cell = cells.emplace_back(Cell{.seed = seed});
        cell.pieces.push_back(withCanonicalWinding({.outer = diagram.cells[seed], .holes = {}}));
        cell.area = area(cell.pieces[0]);
        cell.centroid = centroid(cell.pieces[0]);
        cell.neighbours = neighboursOf(seed, diagram);
    }
    return cells;
}

std::string thesisJson(const FractureInput& input) {
    const ThesisDiagram diagram = thesisDiagram(input.prism.outline.outer, input.seeds);
    return cellsJson(thesisCells(diagram), inOrder(diagram.triangles, input.seeds), input.diagnostics);
}

}  // namespace rubble
