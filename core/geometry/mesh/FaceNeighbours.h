#pragma once

#include "core/geometry/mesh/Mesh.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rubble {

/// The faces on both sides of each edge of a mesh. O(n log n) to build, O(log n) for an edge.
class FaceNeighbours {
public:
    explicit FaceNeighbours(const Mesh& mesh);

    /// Calls visit(face) for each face that has the edge from one position to another in the opposite direction: the
    /// neighbours of a face that has it in this one. In ascending order.
    template <class Visit>
    void forEachBeside(std::uint32_t from, std::uint32_t to, const Visit& visit) const {
        auto back = std::ranges::lower_bound(m_edges, DirectedEdge{to, from, 0});
        for (; back != m_edges.end() && back->from == to && back->to == from; ++back) visit(back->face);
    }

    /// The same for all edges of a face.
    template <class Visit>
    void forEachAround(const Mesh& mesh, std::uint32_t face, const Visit& visit) const {
        const std::span<const MeshCorner> corners = mesh.cornersOf(mesh.faces[face]);
        for (std::size_t k = 0; k < corners.size(); ++k)
            forEachBeside(corners[k].position, corners[(k + 1) % corners.size()].position, visit);
    }

private:
    struct DirectedEdge {
        std::uint32_t from = 0, to = 0;  // positions
        std::uint32_t face = 0;
        auto operator<=>(const DirectedEdge&) const = default;
    };
    std::vector<DirectedEdge> m_edges;  // sorted
};

}  // namespace rubble
