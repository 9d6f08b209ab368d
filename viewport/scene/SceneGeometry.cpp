#include "viewport/scene/SceneGeometry.h"

#include "core/base/Assert.h"
#include "core/geometry/mesh/FaceNeighbours.h"
#include "viewport/scene/SolidBuilder.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kCurvedCosine = 0.866;  // of 30 degrees: flatter creases of the outside are a curved surface
constexpr double kRoughCosine = 0.5;     // of 60 degrees: flatter creases of rough cuts are bumps

/// Which edges of a mesh are visible: all but those between faces in one plane, and flat creases of the outside.
class VisibleEdges {
public:
    VisibleEdges(const Mesh& mesh, bool isRough) : m_mesh(mesh), m_neighbours(mesh), m_isRough(isRough) {}

    /// Of a face, from one position to another.
    bool has(const MeshFace& face, std::uint32_t from, std::uint32_t to) const {
        bool isHidden = false;
        m_neighbours.forEachBeside(from, to,
                                   [&](std::uint32_t other) { isHidden |= areOne(face, m_mesh.faces[other]); });
        return !isHidden;
    }

private:
    /// Whether two faces are parts of one surface.
    bool areOne(const MeshFace& face, const MeshFace& other) const {
        if (other.side != face.side) return false;
        if (other.normal == face.normal) return true;
        const double cosine = glm::dot(m_mesh.normals[other.normal], m_mesh.normals[face.normal]);
        return face.side == FaceSide::Inside ? m_isRough && cosine > kRoughCosine : cosine > kCurvedCosine;
    }

    const Mesh& m_mesh;
    FaceNeighbours m_neighbours;
    bool m_isRough;
};

VertexSide sideOf(const MeshFace& face, const Texture* texture) {
    if (face.side == FaceSide::Inside) return VertexSide::Inside;
    return texture != nullptr && texture->covers(face.material) ? VertexSide::Textured : VertexSide::Outside;
}

/// Of each position of a mesh the sum of the normals of the cuts there.
std::vector<Vec3> cutNormals(const Mesh& mesh) {
    std::vector<Vec3> sums(mesh.positions.size(), Vec3(0.0));
    for (const MeshFace& face : mesh.faces) {
        if (face.side != FaceSide::Inside) continue;
        for (const MeshCorner& corner : mesh.cornersOf(face)) sums[corner.position] += mesh.normals[face.normal];
    }
    return sums;
}

void addFaces(const SolidPart& part, const Texture* texture, SolidBuilder& builder) {
    const Mesh& mesh = part.mesh;
    const VisibleEdges edges(mesh, part.isRough);
    const std::vector<Vec3> sums = part.isRough ? cutNormals(mesh) : std::vector<Vec3>();
    const auto normalAt = [&](const MeshFace& face, std::uint32_t position) -> std::optional<Vec3> {
        if (!part.isRough || face.side != FaceSide::Inside) return std::nullopt;
        const Vec3 normal = glm::normalize(sums[position] + 1e-9 * mesh.normals[face.normal]);
        return glm::dot(normal, mesh.normals[face.normal]) > kRoughCosine ? std::optional(normal) : std::nullopt;
    };
    for (const MeshFace& face : mesh.faces) {
        builder.beginFace(mesh.normals[face.normal], sideOf(face, texture));
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            builder.addCorner(mesh.positions[corners[k].position], mesh.uvs[corners[k].uv],
                              edges.has(face, corners[k].position, corners[(k + 1) % corners.size()].position),
                              normalAt(face, corners[k].position));
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

double SceneGeometry::meanPartSize() const {
    const std::size_t first = whole == Whole::Solid ? 1 : 0;
    if (boxes.size() <= first) return 0.0;
    double sum = 0.0;
    for (std::size_t k = first; k < boxes.size(); ++k) sum += boxes[k].diagonal();
    return sum / static_cast<double>(boxes.size() - first);
}

void endSilhouette(SceneGeometry& geometry, SceneGeometry::Whole whole) {
    RUBBLE_ASSERT(geometry.solidCount() == 1);
    geometry.silhouetteIndices = {0, geometry.indices.size()};
    geometry.wholeBox = geometry.boxes.front();
    geometry.boxes.clear();
    geometry.firstIndices.clear();
    geometry.whole = whole;
    if (whole != SceneGeometry::Whole::None) geometry.wholeIndices = geometry.silhouetteIndices;
}

void endWhole(SceneGeometry& geometry) {
    RUBBLE_ASSERT(geometry.solidCount() == 1);
    geometry.whole = SceneGeometry::Whole::Solid;
    geometry.wholeIndices = {geometry.silhouetteIndices.end, geometry.indices.size()};
    if (geometry.silhouetteIndices.size() == 0) geometry.silhouetteIndices = geometry.wholeIndices;
    geometry.wholeBox = geometry.boxes.front();
}

void addSolid(SceneGeometry& geometry, std::span<const SolidPart> parts, const Texture* texture) {
    const std::size_t firstVertex = geometry.vertices.size();
    Box3 box;
    for (const SolidPart& part : parts) {
        for (const Vec3& position : part.mesh.positions) box.include(position);
    }
    SolidBuilder builder(geometry, box.diagonal());
    for (const SolidPart& part : parts) {
        addFaces(part, texture, builder);
        for (const PlainFace& face : part.mortar) {
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
