#pragma once

#include "core/fracture/solid/SolidSigns.h"
#include "core/fracture/solid/Tetrahedralization.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The Voronoi diagram of sites in space, as the dual of their triangulation: cells and their neighbours, the facets
/// between two cells, and the Voronoi edges between three. Far sites have none of these.
class SolidDiagram {
public:
    /// Incomplete if the task is cancelled.
    explicit SolidDiagram(Tetrahedralization sites, const TaskContext& task = {});

    /// A neighbour of a cell.
    struct Neighbour {
        std::uint32_t site = 0;
        std::uint32_t facet = 0;  // between the two
    };
    /// A Voronoi edge, along (s_j - s_i) × (s_k - s_i) for its ascending sites i, j, k: from a Voronoi corner to
    /// another, each that of a tetrahedron.
    struct Edge {
        std::array<std::uint32_t, 3> site{};
        std::uint32_t from = 0, to = 0;  // tetrahedra
    };

    const Tetrahedralization& sites() const { return m_sites; }
    RankedSite site(std::uint32_t index) const { return {m_sites.sites[index], m_sites.seedOf[index]}; }
    std::uint32_t siteCount() const { return m_sites.siteCount(); }
    /// The neighbours of a cell, ascending.
    std::span<const Neighbour> neighboursOf(std::uint32_t site) const {
        return std::span(m_neighbours)
            .subspan(m_firstNeighbour[site], m_firstNeighbour[site + 1] - m_firstNeighbour[site]);
    }
    /// The two sites of each facet, the lower one first, ascending.
    std::span<const std::array<std::uint32_t, 2>> facets() const { return m_facets; }
    std::span<const Edge> edges() const { return m_edges; }
    /// The facet between two neighbours, and the edge between three.
    std::uint32_t facetOf(std::uint32_t a, std::uint32_t b) const;
    std::uint32_t edgeOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    /// The cell that holds a point of the lattice: that of the nearest site, found from the cell `start`.
    std::uint32_t cellOf(Vec3 point, std::uint32_t start) const;
    /// Whether a tetrahedron's Voronoi corner is outside the lattice's box: it has a far site.
    bool isFar(std::uint32_t tetrahedron) const;

private:
    void findNeighbours(const TaskContext& task);
    void findEdges(const TaskContext& task);
    void fillEdgeTable(const TaskContext& task);
    std::size_t placeOf(const std::array<std::uint32_t, 3>& site) const;

    Tetrahedralization m_sites;
    std::vector<std::uint32_t> m_firstNeighbour;
    std::vector<Neighbour> m_neighbours;
    std::vector<std::array<std::uint32_t, 2>> m_facets;
    std::vector<Edge> m_edges;
    std::vector<std::uint32_t> m_edgeTable;  // open addressing, by hash of the sites; kNone: free
};

}  // namespace rubble
