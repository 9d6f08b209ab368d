#include "core/io/exchange/GlbBuffer.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

std::array<float, 3> toFloats(Vec3 value) {
    // Adding zero turns -0 into 0.
    return {static_cast<float>(value.x) + 0.0f, static_cast<float>(value.y) + 0.0f, static_cast<float>(value.z) + 0.0f};
}

template <class T>
std::size_t sizeOf(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

template <class T>
void appendArray(std::string& bytes, const std::vector<T>& list) {
    bytes.append(reinterpret_cast<const char*>(list.data()), sizeOf(list));
}

std::uint32_t materialOf(const MeshFace& face) {
    return face.side == FaceSide::Inside ? GlbBuffer::kInside : face.material;
}

/// Sets the bounds of a primitive to those of its positions.
void setBounds(GlbPrimitive& primitive, const std::vector<std::array<float, 3>>& positions) {
    primitive.min = primitive.max = positions[primitive.firstVertex];
    for (std::uint32_t i = 0; i < primitive.vertexCount; ++i) {
        const std::array<float, 3>& position = positions[primitive.firstVertex + i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            primitive.min[axis] = std::min(primitive.min[axis], position[axis]);
            primitive.max[axis] = std::max(primitive.max[axis], position[axis]);
        }
    }
}

}  // namespace

std::vector<GlbPrimitive> GlbBuffer::add(const Mesh& mesh) {
    const Mesh triangles = triangulated(mesh);
    RUBBLE_ASSERT(!m_hasTangents || triangles.tangents.size() == triangles.faces.size());
    m_last.assign(triangles.positions.size(), {});
    std::vector<GlbPrimitive> primitives;
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
        const MeshFace& face = triangles.faces[f];
        if (primitives.empty() || primitives.back().material != materialOf(face)) {
            primitives.push_back({vertexCount(), 0, indexCount(), 0, materialOf(face), {}, {}});
        }
        GlbPrimitive& primitive = primitives.back();
        for (const MeshCorner corner : triangles.cornersOf(face)) {
            m_indices.push_back(vertexOf(triangles, corner, f, primitive) - primitive.firstVertex);
        }
        primitive.vertexCount = vertexCount() - primitive.firstVertex;
        primitive.indexCount = indexCount() - primitive.firstIndex;
    }
    for (GlbPrimitive& primitive : primitives) setBounds(primitive, m_positions);
    return primitives;
}

void GlbBuffer::addHull(const Polytope& hull) {
    RUBBLE_ASSERT(!hull.vertices.empty());
    GlbPrimitive primitive{.firstVertex = hullVertexCount(), .firstIndex = hullIndexCount()};
    for (const Vec3& vertex : hull.vertices) m_hullPositions.push_back(toFloats(vertex));
    for (const std::vector<std::uint32_t>& face : hull.faces) {
        for (std::size_t k = 2; k < face.size(); ++k)
            m_hullIndices.insert(m_hullIndices.end(), {face[0], face[k - 1], face[k]});
    }
    primitive.vertexCount = hullVertexCount() - primitive.firstVertex;
    primitive.indexCount = hullIndexCount() - primitive.firstIndex;
    setBounds(primitive, m_hullPositions);
    m_hulls.push_back(primitive);
}

std::uint32_t GlbBuffer::vertexOf(const Mesh& mesh, MeshCorner corner, std::size_t face,
                                  const GlbPrimitive& primitive) {
    const std::uint32_t normal = mesh.faces[face].normal;
    LastVertex& last = m_last[corner.position];
    const bool exists = last.vertex && *last.vertex >= primitive.firstVertex;
    if (exists && last.normal == normal && last.uv == corner.uv) return *last.vertex;
    last = {vertexCount(), normal, corner.uv};
    const Vec2 uv = mesh.uvs[corner.uv];
    m_positions.push_back(toFloats(mesh.positions[corner.position]));
    m_normals.push_back(toFloats(mesh.normals[normal]));
    m_uvs.push_back({static_cast<float>(uv.x) + 0.0f, static_cast<float>(1.0 - uv.y) + 0.0f});
    if (m_hasTangents) {
        const std::array<float, 3> along = toFloats(Vec3(mesh.tangents[face]));
        m_tangents.push_back({along[0], along[1], along[2], static_cast<float>(mesh.tangents[face].w)});
    }
    return *last.vertex;
}

std::size_t GlbBuffer::size() const {
    return sizeOf(m_positions) + sizeOf(m_normals) + sizeOf(m_uvs) + sizeOf(m_tangents) + sizeOf(m_indices) +
           sizeOf(m_hullPositions) + sizeOf(m_hullIndices);
}

void GlbBuffer::appendTo(std::string& bytes) const {
    appendArray(bytes, m_positions);
    appendArray(bytes, m_normals);
    appendArray(bytes, m_uvs);
    appendArray(bytes, m_tangents);
    appendArray(bytes, m_indices);
    appendArray(bytes, m_hullPositions);
    appendArray(bytes, m_hullIndices);
}

}  // namespace rubble
