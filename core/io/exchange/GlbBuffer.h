#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/Mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A primitive of a GLB mesh: ranges of the buffer's arrays with one material.
struct GlbPrimitive {
    std::uint32_t firstVertex = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::uint32_t material = 0;
    std::array<float, 3> min{};  // of the positions
    std::array<float, 3> max{};
};

/// The binary chunk of a GLB file: four arrays, one after the other, or five with tangents, and two more if there are
/// hulls.
class GlbBuffer {
public:
    static constexpr std::uint32_t kInside = 0xffffffff;
    enum class Tangents { None, OfMeshes };
    /// OfMeshes: all meshes that are added have tangents.
    explicit GlbBuffer(Tangents tangents = Tangents::None) : m_hasTangents(tangents == Tangents::OfMeshes) {}

    /// Adds a mesh as triangles, a primitive for each run of faces with the same material. Inside faces have the
    /// material kInside. Corners with equal position, normal and texture coordinates share a vertex.
    std::vector<GlbPrimitive> add(const Mesh& mesh);
    /// Adds a hull as triangles, a fan for each face. Hulls have arrays of their own: positions and indices.
    void addHull(const Polytope& hull);

    /// The hulls: ranges of their arrays, in the order in which they were added.
    std::span<const GlbPrimitive> hulls() const { return m_hulls; }
    std::uint32_t hullVertexCount() const { return static_cast<std::uint32_t>(m_hullPositions.size()); }
    std::uint32_t hullIndexCount() const { return static_cast<std::uint32_t>(m_hullIndices.size()); }
    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(m_positions.size()); }
    std::uint32_t indexCount() const { return static_cast<std::uint32_t>(m_indices.size()); }
    /// The arrays of meshes; indices are relative to the primitive's first vertex.
    std::span<const std::array<float, 3>> positions() const { return m_positions; }
    std::span<const std::array<float, 3>> normals() const { return m_normals; }
    std::span<const std::array<float, 2>> uvs() const { return m_uvs; }
    std::span<const std::uint32_t> indices() const { return m_indices; }
    bool hasTangents() const { return m_hasTangents; }
    /// Of meshes: the last is that of indices.
    std::uint64_t arrayCount() const { return m_hasTangents ? 5 : 4; }
    /// The size of all arrays in bytes.
    std::size_t size() const;
    /// Appends the arrays: positions, normals, texture coordinates (v down, as in glTF), tangents, indices; positions
    /// and indices of hulls; little-endian.
    void appendTo(std::string& bytes) const;

private:
    /// The last vertex created for a position.
    struct LastVertex {
        std::optional<std::uint32_t> vertex;
        std::uint32_t normal = 0;
        std::uint32_t uv = 0;
    };
    std::uint32_t vertexOf(const Mesh& mesh, MeshCorner corner, std::size_t face, const GlbPrimitive& primitive);

    bool m_hasTangents;
    std::vector<std::array<float, 3>> m_positions;
    std::vector<std::array<float, 3>> m_normals;
    std::vector<std::array<float, 2>> m_uvs;
    std::vector<std::array<float, 4>> m_tangents;
    std::vector<std::uint32_t> m_indices;  // relative to the primitive's first vertex
    std::vector<GlbPrimitive> m_hulls;
    std::vector<std::array<float, 3>> m_hullPositions;
    std::vector<std::uint32_t> m_hullIndices;  // relative to the hull's first vertex
    std::vector<LastVertex> m_last;            // by position of the mesh being added
};

}  // namespace rubble
