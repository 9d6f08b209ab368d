#include "viewport/scene/SceneGeometry.h"

#include "viewport/scene/SolidBuilder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;  // from position to position

/// The directed edges of faces [first, end), sorted.
std::vector<DirectedEdge> edgesOf(const Mesh& mesh, std::size_t first, std::size_t end) {
    std::vector<DirectedEdge> edges;
    for (std::size_t f = first; f < end; ++f) {
        const std::span<const MeshCorner> corners = mesh.cornersOf(mesh.faces[f]);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            edges.emplace_back(corners[k].position, corners[(k + 1) % corners.size()].position);
        }
    }
    std::ranges::sort(edges);
    return edges;
}

VertexSide sideOf(const MeshFace& face, const Texture* texture) {
    if (face.side == FaceSide::Inside) return VertexSide::Inside;
    return texture != nullptr && texture->covers(face.material) ? VertexSide::Textured : VertexSide::Outside;
}

/// Adds the coplanar faces [first, end).
void addFaces(const Mesh& mesh, const Texture* texture, std::size_t first, std::size_t end, SolidBuilder& builder) {
    const bool isSingle = end - first == 1;
    const std::vector<DirectedEdge> edges = isSingle ? std::vector<DirectedEdge>() : edgesOf(mesh, first, end);
    for (std::size_t f = first; f < end; ++f) {
        const MeshFace& face = mesh.faces[f];
        builder.beginFace(mesh.normals[face.normal], sideOf(face, texture));
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const DirectedEdge back{corners[(k + 1) % corners.size()].position, corners[k].position};
            builder.addCorner(mesh.positions[corners[k].position], mesh.uvs[corners[k].uv],
                              isSingle || !std::ranges::binary_search(edges, back));
        }
        builder.endFace();
    }
}

/// Sets the size code of the last solid's vertices, from `first`.
void setSizeCode(SceneGeometry& geometry, std::size_t first) {
    const double code = 128.0 + 8.0 * std::log2(std::max(geometry.boxes.back().diagonal(), 1e-5));
    for (std::size_t k = first; k < geometry.vertices.size(); ++k) {
        geometry.vertices[k].sizeCode = static_cast<std::uint8_t>(std::clamp(code, 0.0, 255.0));
    }
}

}  // namespace

void addSolid(SceneGeometry& geometry, std::span<const SolidPart> parts, const Texture* texture) {
    const std::size_t firstVertex = geometry.vertices.size();
    SolidBuilder builder(geometry);
    for (const auto& [mesh, mortar] : parts) {
        for (std::size_t first = 0; first < mesh.faces.size();) {
            std::size_t end = first + 1;
            while (end < mesh.faces.size() && mesh.faces[end].normal == mesh.faces[first].normal) ++end;
            addFaces(mesh, texture, first, end, builder);
            first = end;
        }
        for (const PlainFace& face : mortar) {
            builder.beginFace(face.normal, VertexSide::Mortar);
            for (const Vec3 corner : face.corners) builder.addCorner(corner, Vec2(0.0), false);
            builder.endFace();
        }
    }
    setSizeCode(geometry, firstVertex);
}

void addSolid(SceneGeometry& geometry, std::span<const Polytope> hulls) {
    const std::size_t firstVertex = geometry.vertices.size();
    SolidBuilder builder(geometry);
    for (const Polytope& hull : hulls) {
        for (std::size_t f = 0; f < hull.faces.size(); ++f) {
            builder.beginFace(hull.planes[f].normal, VertexSide::Outside);
            for (const std::uint32_t vertex : hull.faces[f]) {
                builder.addCorner(hull.vertices[vertex], Vec2(0.0, 0.0), true);
            }
            builder.endFace();
        }
    }
    setSizeCode(geometry, firstVertex);
}

}  // namespace rubble
