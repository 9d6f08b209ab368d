#include "core/fracture/FreeSquares.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// True where the segment comes into the square, or nearly so; by the separating axes of the two.
bool meetsSquare(Vec2 from, Vec2 to, Vec2 centre, double half) {
    const Vec2 a = from - centre;
    const Vec2 b = to - centre;
    const double reach = half * (1.0 + 1e-9);  // rather one square too many
    if (std::min(a.x, b.x) > reach || std::max(a.x, b.x) < -reach) return false;
    if (std::min(a.y, b.y) > reach || std::max(a.y, b.y) < -reach) return false;
    const Vec2 along = b - a;
    return std::abs(cross(along, a)) <= reach * (std::abs(along.x) + std::abs(along.y));
}

bool meetsSquare(const Ring& ring, Vec2 centre, double half) {
    for (std::size_t corner = 0; corner < ring.size(); ++corner) {
        const Vec2 next = ring[corner + 1 < ring.size() ? corner + 1 : 0];
        if (meetsSquare(ring[corner], next, centre, half)) return true;
    }
    return false;
}

}  // namespace

FreeSquares::FreeSquares(const Polygon& domain) : m_domain(domain) {
    const Box2 box = boundsOf(domain.outer);
    m_side = std::max(box.size().x, box.size().y);
    m_squares.push_back({box.min, false});
}

std::optional<Vec2> FreeSquares::dart(Random& random) const {
    const Square& square = m_squares[random.below(m_squares.size())];
    const double u = random.unit();
    const double v = random.unit();
    const Vec2 point = square.min + m_side * Vec2{u, v};
    if (!square.isInside && containment(m_domain, point) == Containment::Outside) return std::nullopt;
    return point;
}

std::optional<FreeSquares::Square> FreeSquares::partInDomain(Square square) const {
    if (square.isInside) return square;
    const double half = m_side / 2.0;
    const Vec2 centre = square.min + Vec2{half, half};
    bool isCrossed = meetsSquare(m_domain.outer, centre, half);
    for (const Ring& hole : m_domain.holes) isCrossed = isCrossed || meetsSquare(hole, centre, half);
    if (isCrossed) return square;
    if (containment(m_domain, centre) == Containment::Outside) return std::nullopt;
    return Square{square.min, true};
}

Status FreeSquares::quarter(const SeedGrid& seeds, const TaskContext& task) {
    m_side /= 2.0;
    std::vector<Square> smaller;
    for (std::size_t k = 0; k < m_squares.size(); ++k) {
        if (k % 1024 == 0 && task.isCancelled()) return TaskContext::cancelled();
        for (const Vec2 corner : {Vec2{0.0, 0.0}, Vec2{m_side, 0.0}, Vec2{0.0, m_side}, Vec2{m_side, m_side}}) {
            const Square quarter{m_squares[k].min + corner, m_squares[k].isInside};
            if (seeds.isCovered(quarter.min, m_side)) continue;
            if (const std::optional<Square> kept = partInDomain(quarter)) smaller.push_back(*kept);
        }
    }
    m_squares = std::move(smaller);
    return success();
}

}  // namespace rubble
