#include "bench/Cells.h"

#include <array>

namespace rubble::bench {

namespace {

constexpr std::array<HalfPlane, 4> kSidesOfSquare = {HalfPlane{{-1.0, 0.0}, 0.0}, HalfPlane{{1.0, 0.0}, 1.0},
                                                     HalfPlane{{0.0, -1.0}, 0.0}, HalfPlane{{0.0, 1.0}, 1.0}};
constexpr std::array<Vec2, 4> kSquare = {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{1.0, 1.0}, Vec2{0.0, 1.0}};
constexpr std::size_t kCornersOfACell = 6;  // on average

}  // namespace

double areaOf(const Cells& cells) {
    double sum = 0.0;
    std::size_t begin = 0;
    for (const std::uint32_t end : cells.ends) {
        sum += signedArea(std::span(cells.corners).subspan(begin, end - begin));
        begin = end;
    }
    return sum;
}

CellWriter::CellWriter(std::size_t seeds) {
    m_cells.corners.reserve((kCornersOfACell + 1) * seeds);
    m_cells.ends.reserve(seeds);
    m_cells.seeds.reserve(seeds);
}

void CellWriter::endBounded(std::uint32_t seed) {
    if (!m_leaves) return end(seed);
    m_ring.assign(m_cells.corners.begin() + static_cast<std::ptrdiff_t>(m_first), m_cells.corners.end());
    for (const HalfPlane& side : kSidesOfSquare) clipRing(side);
    endWithRing(seed);
}

void CellWriter::endUnbounded(std::uint32_t seed, Vec2 site, std::span<const Vec2> neighbours) {
    m_ring.assign(kSquare.begin(), kSquare.end());
    for (const Vec2 neighbour : neighbours) clipRing(nearerTo(site, neighbour));
    endWithRing(seed);
}

void CellWriter::clipRing(const HalfPlane& halfPlane) {
    clipByHalfPlane(m_ring, halfPlane, m_clipped);
    m_ring.swap(m_clipped);
}

void CellWriter::endWithRing(std::uint32_t seed) {
    m_cells.corners.resize(m_first);
    m_cells.corners.insert(m_cells.corners.end(), m_ring.begin(), m_ring.end());
    end(seed);
}

void CellWriter::end(std::uint32_t seed) {
    m_first = m_cells.corners.size();
    m_cells.ends.push_back(static_cast<std::uint32_t>(m_first));
    m_cells.seeds.push_back(seed);
    m_leaves = false;
}

}  // namespace rubble::bench
