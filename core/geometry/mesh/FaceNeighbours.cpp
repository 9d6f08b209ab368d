#include "core/geometry/mesh/FaceNeighbours.h"

namespace rubble {

FaceNeighbours::FaceNeighbours(const Mesh& mesh) {
    m_edges.reserve(mesh.corners.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        const std::span<const MeshCorner> corners = mesh.cornersOf(mesh.faces[f]);
        for (std::size_t k = 0; k < corners.size(); ++k)
            m_edges.push_back({corners[k].position, corners[(k + 1) % corners.size()].position, f});
    }
    std::ranges::sort(m_edges);
}

}  // namespace rubble
