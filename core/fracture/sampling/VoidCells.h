#pragma once

#include "core/base/Random.h"
#include "core/base/TaskContext.h"
#include "core/fracture/sampling/SeedGrid.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <optional>
#include <vector>

namespace rubble {

/// The void cells of Poisson-disk sampling: the parts of a domain where a seed may still fit. Square cells of equal
/// size are subdivided repeatedly; cells outside the domain or covered by a seed are removed. The rest converges to the
/// gaps.
/// Source: Ebeida, Mitchell, Patney, Davidson, Owens, "A simple algorithm for maximal Poisson-disk sampling in high
/// dimensions", 2012.
class VoidCells {
public:
    /// Starts with one cell around the domain.
    explicit VoidCells(const Polygon& domain);

    bool isEmpty() const { return m_cells.empty(); }
    std::size_t size() const { return m_cells.size(); }
    double side() const { return m_side; }  // m

    /// A random point of a random cell; nothing if it misses the domain. Draws three random numbers.
    std::optional<Vec2> dart(Random& random) const;
    /// Subdivides every cell into four and keeps those that are neither outside nor covered.
    ///
    /// Errors: Cancelled.
    Status subdivide(const SeedGrid& seeds, const TaskContext& task);

private:
    struct Cell {
        Vec2 min;
        bool isInside;  // entirely in the domain: no more tests needed
    };
    std::optional<Cell> clippedToDomain(Cell square) const;

    ContainmentIndex m_domain;
    double m_side;
    std::vector<Cell> m_cells;
};

}  // namespace rubble
