#pragma once

#include "core/base/Random.h"
#include "core/base/TaskContext.h"
#include "core/fracture/sampling/SeedGrid.h"
#include "core/fracture/sampling/SolidScatterDomain.h"

#include <optional>
#include <vector>

namespace rubble {

/// What VoidCells are in the plane: the parts of a closed mesh where a seed may still fit, as cubes.
class SolidVoidCells {
public:
    /// Starts with one cell around the domain, which is borrowed.
    explicit SolidVoidCells(const SolidScatterDomain& domain);

    bool isEmpty() const { return m_cells.empty(); }
    std::size_t size() const { return m_cells.size(); }
    double side() const { return m_side; }  // m

    /// A random point of a random cell; nothing if it misses the domain. Draws four random numbers.
    std::optional<Vec3> dart(Random& random) const;
    /// Subdivides every cell into eight and keeps those that are neither outside nor covered.
    ///
    /// Errors: Cancelled.
    Status subdivide(const SolidSeedGrid& seeds, const TaskContext& task);

private:
    struct Cell {
        Vec3 min;
        bool isInside;  // entirely in the domain: no more tests needed
    };
    std::optional<Cell> clippedToDomain(Cell cube) const;

    const SolidScatterDomain& m_domain;
    double m_side;
    std::vector<Cell> m_cells;
};

}  // namespace rubble
