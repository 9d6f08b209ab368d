#include "core/fracture/sampling/VoidCells.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Whether a segment intersects a cell, or nearly so: separating axis test.
bool intersectsSquare(Vec2 from, Vec2 to, Vec2 centre, double half) {
    const Vec2 a = from - centre;
    const Vec2 b = to - centre;
    const double extent = half * (1.0 + 1e-9);  // conservative
    if (std::min(a.x, b.x) > extent || std::max(a.x, b.x) < -extent) return false;
    if (std::min(a.y, b.y) > extent || std::max(a.y, b.y) < -extent) return false;
    const Vec2 along = b - a;
    return std::abs(cross(along, a)) <= extent * (std::abs(along.x) + std::abs(along.y));
}

}  // namespace

VoidCells::VoidCells(const Polygon& domain) : m_domain(domain) {
    const Box2 box = boundsOf(domain.outer);
    m_side = std::max(box.size().x, box.size().y);
    m_cells.push_back({box.min, false});
}

std::optional<Vec2> VoidCells::dart(Random& random) const {
    const Cell& cell = m_cells[random.below(m_cells.size())];
    const double u = random.unit();
    const double v = random.unit();
    const Vec2 point = cell.min + m_side * Vec2{u, v};
    if (!cell.isInside && m_domain.of(point) == Containment::Outside) return std::nullopt;
    return point;
}

std::optional<VoidCells::Cell> VoidCells::clippedToDomain(Cell cell) const {
    if (cell.isInside) return cell;
    const double half = m_side / 2.0;
    const Vec2 centre = cell.min + Vec2{half, half};
    const Vec2 margin(m_side, m_side);  // conservative: intersectsSquare() decides
    const auto meets = [&](Vec2 from, Vec2 to) { return intersectsSquare(from, to, centre, half); };
    if (m_domain.hasEdge(centre - margin, centre + margin, meets)) return cell;
    if (m_domain.of(centre) == Containment::Outside) return std::nullopt;
    return Cell{cell.min, true};
}

Status VoidCells::subdivide(const SeedGrid& seeds, const TaskContext& task) {
    m_side /= 2.0;
    std::vector<Cell> smaller;
    for (std::size_t k = 0; k < m_cells.size(); ++k) {
        if (k % 1024 == 0 && task.isCancelled()) return TaskContext::cancelled();
        for (const Vec2 corner : {Vec2{0.0, 0.0}, Vec2{m_side, 0.0}, Vec2{0.0, m_side}, Vec2{m_side, m_side}}) {
            const Cell quarter{m_cells[k].min + corner, m_cells[k].isInside};
            if (seeds.isCovered(quarter.min, m_side)) continue;
            if (const std::optional<Cell> kept = clippedToDomain(quarter)) smaller.push_back(*kept);
        }
    }
    m_cells = std::move(smaller);
    return success();
}

}  // namespace rubble
