#include "core/fracture/voronoi/LocalDiagram.h"

#include "core/fracture/voronoi/OutlineTrace.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_set>

namespace rubble {
namespace {

void sortUnique(std::vector<std::uint32_t>& seeds) {
    std::ranges::sort(seeds);
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
}

/// The corner that is the ghost; 3 if none is.
std::uint32_t ghostCorner(const Delaunay::Triangle& triangle) {
    return static_cast<std::uint32_t>(std::ranges::find(triangle.corner, kGhost) - std::begin(triangle.corner));
}

}  // namespace

LocalDiagram::LocalDiagram(std::span<const Vec2> positions, const Delaunay& delaunay)
    : m_positions(positions),
      m_delaunay(delaunay),
      m_outgoing(outgoingHalfEdges(delaunay)),
      m_siteOf(positions.size(), kNone) {
    for (std::uint32_t site = 0; site < delaunay.seedOf.size(); ++site) m_siteOf[delaunay.seedOf[site]] = site;
    for (const auto& [seed, of] : delaunay.duplicates) m_siteOf[seed] = m_siteOf[of];
    for (std::uint32_t t = 0; t < delaunay.triangles.size() && m_inner == kNone; ++t) {
        if (ghostCorner(delaunay.triangles[t]) == 3) m_inner = t;
    }
}

void LocalDiagram::addNeighbours(std::uint32_t seed, Seeds& seeds) const {
    const std::uint32_t first = m_outgoing[m_siteOf[seed]];
    std::uint32_t halfEdge = first;
    do {
        const std::uint32_t site = targetOf(m_delaunay, halfEdge);
        if (site != kGhost) seeds.push_back(m_delaunay.seedOf[site]);
        halfEdge = nextAround(m_delaunay, halfEdge);
    } while (halfEdge != first);
}

/// Whether a new site at the position would remove the triangle's Voronoi corner: its circle contains the position.
bool LocalDiagram::isCut(std::uint32_t triangle, Vec2 position) const {
    const std::uint32_t* corner = m_delaunay.triangles[triangle].corner;
    const std::uint32_t ghost = ghostCorner(m_delaunay.triangles[triangle]);
    const auto& sites = m_delaunay.sites;
    if (ghost == 3) return inCircle(sites[corner[0]], sites[corner[1]], sites[corner[2]], position) >= 0;
    return orient2d(sites[corner[(ghost + 1) % 3]], sites[corner[(ghost + 2) % 3]], position) >= 0;
}

std::uint32_t LocalDiagram::triangleBeside(std::uint32_t seed) const {
    const std::uint32_t first = m_outgoing[m_siteOf[seed]];
    std::uint32_t halfEdge = first;
    do {
        const std::uint32_t triangle = Delaunay::triangleOf(halfEdge);
        if (ghostCorner(m_delaunay.triangles[triangle]) == 3) return triangle;
        halfEdge = nextAround(m_delaunay, halfEdge);
    } while (halfEdge != first);
    return m_inner;
}

/// Walks from a triangle to the one that contains the position, or to a ghost. The walk ends, as in every Delaunay
/// triangulation: the power of the position with respect to the circles decreases with each step.
std::uint32_t LocalDiagram::triangleAt(Vec2 position, std::uint32_t start) const {
    std::uint32_t triangle = start;
    for (std::uint32_t k = 0; k < 3;) {
        const std::uint32_t halfEdge = 4 * triangle + k;
        const Vec2 from = m_delaunay.sites[m_delaunay.origin(halfEdge)];
        const Vec2 to = m_delaunay.sites[targetOf(m_delaunay, halfEdge)];
        ++k;
        if (orient2d(from, to, position) >= 0) continue;
        triangle = Delaunay::triangleOf(m_delaunay.twin(halfEdge));
        if (ghostCorner(m_delaunay.triangles[triangle]) != 3) return triangle;
        k = 0;
    }
    return triangle;
}

/// Adds the seeds whose cells shrink if a site is inserted at a position: the corners of the triangles whose circles
/// contain it, which are connected.
void LocalDiagram::addCut(Vec2 position, std::uint32_t start, Seeds& seeds) const {
    std::vector<std::uint32_t> open = {triangleAt(position, start)};
    std::unordered_set<std::uint32_t> seen(open.begin(), open.end());
    while (!open.empty()) {
        const Delaunay::Triangle& triangle = m_delaunay.triangles[open.back()];
        open.pop_back();
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (triangle.corner[k] != kGhost) seeds.push_back(m_delaunay.seedOf[triangle.corner[k]]);
            const std::uint32_t next = Delaunay::triangleOf(triangle.twin[k]);
            if (isCut(next, position) && seen.insert(next).second) open.push_back(next);
        }
    }
}

/// Adds the duplicates of the seeds: if a seed moves away, the next duplicate takes its place.
void LocalDiagram::addDuplicates(Seeds& seeds) const {
    const std::size_t count = seeds.size();
    for (const auto& [seed, of] : m_delaunay.duplicates) {
        if (std::binary_search(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(count), of)) {
            seeds.push_back(seed);
        }
    }
}

LocalDiagram::Seeds LocalDiagram::changedBy(std::span<const MovedSeed> moved) const {
    Seeds changed;
    for (const auto& [seed, position] : moved) {
        changed.push_back(seed);
        changed.push_back(m_delaunay.seedOf[m_siteOf[seed]]);
        addNeighbours(seed, changed);
        addCut(position, triangleBeside(seed), changed);
    }
    sortUnique(changed);
    addDuplicates(changed);
    sortUnique(changed);
    return changed;
}

Result<LocalCells> LocalDiagram::cellsAround(const Polygon& outline, std::span<const MovedSeed> moved) const {
    for (const auto& [seed, position] : moved) {
        if (isExactlyUsable(position)) continue;
        return Error{ErrorCode::BadInput, "Seed " + std::to_string(seed) + " " + *coordinateFault(position) + "."};
    }
    LocalCells cells;
    Seeds changed;
    if (m_inner == kNone) {
        changed.resize(m_positions.size());
        std::iota(changed.begin(), changed.end(), 0u);
        cells.seeds = changed;
    } else {
        changed = changedBy(moved);
        cells.seeds = changed;
        for (const std::uint32_t seed : changed) addNeighbours(seed, cells.seeds);
        sortUnique(cells.seeds);
        addDuplicates(cells.seeds);
        sortUnique(cells.seeds);
    }
    const auto localIndexOf = [&](std::uint32_t seed) {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(cells.seeds, seed) - cells.seeds.begin());
    };
    for (const std::uint32_t seed : changed) cells.complete.push_back(localIndexOf(seed));
    for (const std::uint32_t seed : cells.seeds) cells.positions.push_back(m_positions[seed]);
    for (const auto& [seed, position] : moved) cells.positions[localIndexOf(seed)] = position;

    Result<Delaunay> triangulation = triangulate(cells.positions);
    if (!triangulation) return triangulation.error();
    cells.triangulation = std::move(*triangulation);
    Result<Partition> partition = voronoiPartition(outline, cells.triangulation);
    if (!partition) return partition.error();
    cells.partition = std::move(*partition);
    return cells;
}

}  // namespace rubble
