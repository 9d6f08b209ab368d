#include "core/fracture/sampling/SolidVoidCells.h"

#include <numbers>

namespace rubble {
namespace {

constexpr double kHalfDiagonal = std::numbers::sqrt3 / 2.0 * (1.0 + 1e-9);  // of a cube; conservative

}  // namespace

SolidVoidCells::SolidVoidCells(const SolidScatterDomain& domain)
    : m_domain(domain), m_side(std::max({domain.size().x, domain.size().y, domain.size().z})) {
    m_cells.push_back({domain.solid.bounds().min, false});
}

std::optional<Vec3> SolidVoidCells::dart(Random& random) const {
    const Cell& cell = m_cells[random.below(m_cells.size())];
    const double x = random.unit(), y = random.unit(), z = random.unit();
    const Vec3 point = cell.min + m_side * Vec3(x, y, z);
    if (!cell.isInside && m_domain.depth(point) < 0.0) return std::nullopt;
    return point;
}

std::optional<SolidVoidCells::Cell> SolidVoidCells::clippedToDomain(Cell cell) const {
    if (cell.isInside) return cell;
    const double depth = m_domain.depth(cell.min + m_side / 2.0), extent = kHalfDiagonal * m_side;
    if (depth < -extent) return std::nullopt;
    return Cell{cell.min, depth > extent};
}

Status SolidVoidCells::subdivide(const SolidSeedGrid& seeds, const TaskContext& task) {
    m_side /= 2.0;
    std::vector<Cell> smaller;
    for (std::size_t k = 0; k < m_cells.size(); ++k) {
        if (k % 256 == 0 && task.isCancelled()) return TaskContext::cancelled();
        for (int corner = 0; corner < 8; ++corner) {
            const Cell octant{m_cells[k].min + m_side * Vec3(corner & 1, corner >> 1 & 1, corner >> 2),
                              m_cells[k].isInside};
            if (seeds.isCovered(octant.min, m_side)) continue;
            if (const std::optional<Cell> kept = clippedToDomain(octant)) smaller.push_back(*kept);
        }
    }
    m_cells = std::move(smaller);
    return success();
}

}  // namespace rubble
