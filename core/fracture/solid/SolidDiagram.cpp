#include "core/fracture/solid/SolidDiagram.h"

#include "core/base/Assert.h"
#include "core/base/Groups.h"
#include "core/base/Parallel.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace rubble {
namespace {

using Tetrahedron = Tetrahedralization::Tetrahedron;

/// Whether a permutation of three is even.
bool isEven(const std::array<std::uint32_t, 3>& site) {
    return (site[0] < site[1]) == ((site[1] < site[2]) == (site[0] < site[2]));
}

}  // namespace

SolidDiagram::SolidDiagram(Tetrahedralization sites, const TaskContext& task) : m_sites(std::move(sites)) {
    forEachIndex(2, task.threads, [&](std::size_t part) {
        if (part == 0) return findNeighbours(task);
        findEdges(task);
        fillEdgeTable(task);
    });
}

void SolidDiagram::findNeighbours(const TaskContext& task) {
    const std::uint32_t count = siteCount();
    const Groups<std::uint32_t> all = grouped<std::uint32_t>(count, [&](const auto& visit) {
        for (const Tetrahedron& tetrahedron : m_sites.tetrahedra) {
            if (task.isCancelled()) return;
            for (const std::uint32_t a : tetrahedron.corner) {
                if (m_sites.isFar(a)) continue;
                for (const std::uint32_t b : tetrahedron.corner) {
                    if (b != a && !m_sites.isFar(b)) visit(a, b);
                }
            }
        }
    });

    m_firstNeighbour.assign(1, 0);
    std::vector<std::uint32_t> seenBy(count, kNone), neighbours;
    for (std::uint32_t site = 0; site < count && !task.isCancelled(); ++site) {
        neighbours.clear();
        for (const std::uint32_t other : all.of(site)) {
            if (seenBy[other] != site) neighbours.push_back(other);
            seenBy[other] = site;
        }
        std::sort(neighbours.begin(), neighbours.end());
        for (const std::uint32_t other : neighbours) {
            std::uint32_t facet = static_cast<std::uint32_t>(m_facets.size());
            if (other > site)
                m_facets.push_back({site, other});
            else
                facet = facetOf(other, site);
            m_neighbours.push_back({other, facet});
        }
        m_firstNeighbour.push_back(static_cast<std::uint32_t>(m_neighbours.size()));
    }
}

std::uint32_t SolidDiagram::facetOf(std::uint32_t a, std::uint32_t b) const {
    const std::span<const Neighbour> all = neighboursOf(a);
    const auto found = std::lower_bound(all.begin(), all.end(), b,
                                        [](const Neighbour& n, std::uint32_t site) { return n.site < site; });
    RUBBLE_ASSERT(found != all.end() && found->site == b);
    return found->facet;
}

void SolidDiagram::findEdges(const TaskContext& task) {
    for (std::uint32_t t = 0; t < m_sites.tetrahedra.size() && !task.isCancelled(); ++t) {
        for (int k = 0; k < 4; ++k) {
            const Tetrahedron& tetrahedron = m_sites.tetrahedra[t];
            const std::uint32_t other = tetrahedron.neighbour[k];
            if (other == kNone || other < t) continue;
            std::array<std::uint32_t, 3> site{};
            for (int m = 0; m < 3; ++m) site[m] = tetrahedron.corner[kFaceCorners[k][m]];
            if (m_sites.isFar(*std::max_element(site.begin(), site.end()))) continue;
            // Corner k is on the positive side of orient3d(site), against (s_1 - s_0) × (s_2 - s_0).
            const bool isAlong = !isEven(site);
            std::sort(site.begin(), site.end());
            m_edges.push_back(isAlong ? Edge{site, other, t} : Edge{site, t, other});
        }
    }
}

std::size_t SolidDiagram::placeOf(const std::array<std::uint32_t, 3>& site) const {
    std::uint64_t hash = site[0] * 0x9e3779b97f4a7c15u;
    hash = (hash ^ site[1]) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 29) ^ site[2]) * 0x94d049bb133111ebu;
    std::size_t place = (hash >> 32) & (m_edgeTable.size() - 1);
    while (m_edgeTable[place] != kNone && m_edges[m_edgeTable[place]].site != site) {
        place = (place + 1) & (m_edgeTable.size() - 1);
    }
    return place;
}

void SolidDiagram::fillEdgeTable(const TaskContext& task) {
    m_edgeTable.assign(std::bit_ceil(2 * m_edges.size() + 1), kNone);
    for (std::uint32_t edge = 0; edge < m_edges.size() && !task.isCancelled(); ++edge) {
        m_edgeTable[placeOf(m_edges[edge].site)] = edge;
    }
}

std::uint32_t SolidDiagram::edgeOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    std::array<std::uint32_t, 3> site = {a, b, c};
    std::sort(site.begin(), site.end());
    const std::uint32_t edge = m_edgeTable[placeOf(site)];
    RUBBLE_ASSERT(edge != kNone);
    return edge;
}

std::uint32_t SolidDiagram::cellOf(Vec3 point, std::uint32_t start) const {
    for (std::uint32_t cell = start;;) {
        const RankedSite here = site(cell);
        std::uint32_t nearer = kNone;
        for (const Neighbour& neighbour : neighboursOf(cell)) {
            if (solid_signs::atPoint(point, here, site(neighbour.site)) < 0) continue;
            nearer = neighbour.site;
            break;
        }
        if (nearer == kNone) return cell;
        cell = nearer;
    }
}

bool SolidDiagram::isFar(std::uint32_t tetrahedron) const {
    const std::array<std::uint32_t, 4>& corner = m_sites.tetrahedra[tetrahedron].corner;
    return m_sites.isFar(*std::max_element(corner.begin(), corner.end()));
}

}  // namespace rubble
