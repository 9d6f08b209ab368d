#include "viewport/scene/SceneGeometry.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

constexpr std::uint8_t kOnEdge = 0, kOnOppositeEdge = 255, kAway = 128;

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;  // from position to position

/// Adds the faces of one piece.
class PieceBuilder {
public:
    explicit PieceBuilder(SceneGeometry& geometry) : m_geometry(geometry), m_piece(geometry.pieceCount()) {
        geometry.boxes.emplace_back();
    }

    /// Begins a face; its corners follow.
    void beginFace(Vec3 normal, FaceSide side) {
        m_like.normal = glm::vec3(normal);
        m_like.side = side;
        m_like.piece = m_piece;
        m_corners.clear();
        m_isEdge.clear();
    }
    /// `isEdge` tells of the way to the next corner.
    void addCorner(Vec3 position, Vec2 uv, bool isEdge) {
        m_geometry.boxes.back().include(position);
        SceneVertex vertex = m_like;
        vertex.position = glm::vec3(position);
        vertex.uv = glm::vec2(uv);
        m_corners.push_back(vertex);
        m_isEdge.push_back(isEdge);
    }
    void endFace() {
        const bool areAllEdges = std::ranges::find(m_isEdge, false) == m_isEdge.end();
        if (areAllEdges && m_corners.size() == 4) return addQuad();
        areAllEdges ? addFan() : addFanWithGaps();
    }

private:
    std::uint32_t add(SceneVertex vertex, std::uint8_t s, std::uint8_t t) {
        vertex.across = {s, t};
        m_geometry.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(m_geometry.vertices.size() - 1);
    }
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        m_geometry.indices.insert(m_geometry.indices.end(), {a, b, c});
    }

    void addQuad() {
        const std::uint32_t first = add(m_corners[0], kOnEdge, kOnEdge);
        add(m_corners[1], kOnOppositeEdge, kOnEdge);
        add(m_corners[2], kOnOppositeEdge, kOnOppositeEdge);
        add(m_corners[3], kOnEdge, kOnOppositeEdge);
        addTriangle(first, first + 1, first + 2);
        addTriangle(first, first + 2, first + 3);
    }

    SceneVertex centre() const {
        SceneVertex centre = m_like;
        for (const SceneVertex& corner : m_corners) {
            centre.position += corner.position;
            centre.uv += corner.uv;
        }
        const auto count = static_cast<float>(m_corners.size());
        centre.position /= count;
        centre.uv /= count;
        return centre;
    }

    /// Triangles around the centre: each has one of the face's edges.
    void addFan() {
        const auto count = static_cast<std::uint32_t>(m_corners.size());
        const std::uint32_t middle = add(centre(), kAway, kAway);
        for (const SceneVertex& corner : m_corners) add(corner, kOnEdge, kAway);
        for (std::uint32_t k = 0; k < count; ++k) addTriangle(middle, middle + 1 + k, middle + 1 + (k + 1) % count);
    }

    /// The same where some edges must not show: no triangle shares corners with the next.
    void addFanWithGaps() {
        const SceneVertex middle = centre();
        for (std::size_t k = 0; k < m_corners.size(); ++k) {
            const std::uint8_t s = m_isEdge[k] ? kOnEdge : kAway;
            const std::uint32_t first = add(middle, kAway, kAway);
            add(m_corners[k], s, kAway);
            add(m_corners[(k + 1) % m_corners.size()], s, kAway);
            addTriangle(first, first + 1, first + 2);
        }
    }

    SceneGeometry& m_geometry;
    std::uint32_t m_piece;
    SceneVertex m_like;  // what all corners of the face have
    std::vector<SceneVertex> m_corners;
    std::vector<bool> m_isEdge;
};

/// The ways along all edges of faces [first, end), sorted.
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

/// Adds faces [first, end), which lie in one plane.
void addFaces(const Mesh& mesh, std::size_t first, std::size_t end, PieceBuilder& builder) {
    const bool isOne = end - first == 1;
    const std::vector<DirectedEdge> edges = isOne ? std::vector<DirectedEdge>() : edgesOf(mesh, first, end);
    for (std::size_t f = first; f < end; ++f) {
        const MeshFace& face = mesh.faces[f];
        builder.beginFace(mesh.normals[face.normal], face.side);
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const DirectedEdge back{corners[(k + 1) % corners.size()].position, corners[k].position};
            builder.addCorner(mesh.positions[corners[k].position], mesh.uvs[corners[k].uv],
                              isOne || !std::ranges::binary_search(edges, back));
        }
        builder.endFace();
    }
}

}  // namespace

void addPiece(SceneGeometry& geometry, const Mesh& mesh) {
    PieceBuilder builder(geometry);
    for (std::size_t first = 0; first < mesh.faces.size();) {
        std::size_t end = first + 1;
        while (end < mesh.faces.size() && mesh.faces[end].normal == mesh.faces[first].normal) ++end;
        addFaces(mesh, first, end, builder);
        first = end;
    }
}

void addPiece(SceneGeometry& geometry, std::span<const Polytope> hulls) {
    PieceBuilder builder(geometry);
    for (const Polytope& hull : hulls) {
        for (std::size_t f = 0; f < hull.faces.size(); ++f) {
            builder.beginFace(hull.planes[f].normal, FaceSide::Outside);
            for (const std::uint32_t vertex : hull.faces[f]) {
                builder.addCorner(hull.vertices[vertex], Vec2(0.0, 0.0), true);
            }
            builder.endFace();
        }
    }
}

}  // namespace rubble
