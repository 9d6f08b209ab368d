#pragma once

#include "core/geometry/Mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// What a GLB file draws with one material in one go: runs in the buffer's lists.
struct GlbPrimitive {
    std::uint32_t firstVertex = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::uint32_t material = 0;
    std::array<float, 3> min{};  // of the positions
    std::array<float, 3> max{};
};

/// The numbers of a GLB file as they lie in its binary chunk: four lists one after the other.
class GlbBuffer {
public:
    static constexpr std::uint32_t kInside = 0xffffffff;

    /// Adds a mesh in triangles: a primitive for each run of faces of one material. Inside faces have the material kInside.
    /// Corners of one flat face that share position and texture coordinates share a vertex.
    std::vector<GlbPrimitive> add(const Mesh& mesh);

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(m_positions.size()); }
    std::uint32_t indexCount() const { return static_cast<std::uint32_t>(m_indices.size()); }
    /// The size of all lists.
    std::size_t size() const;
    /// The lists in order: positions, normals, texture coordinates (v down, as glTF has it), indices; little-endian.
    void appendTo(std::string& bytes) const;

private:
    /// The vertex that was made last for a position.
    struct LastVertex {
        std::optional<std::uint32_t> vertex;
        std::uint32_t normal = 0;
        std::uint32_t uv = 0;
    };
    std::uint32_t vertexOf(const Mesh& mesh, MeshCorner corner, std::uint32_t normal, const GlbPrimitive& primitive);

    std::vector<std::array<float, 3>> m_positions;
    std::vector<std::array<float, 3>> m_normals;
    std::vector<std::array<float, 2>> m_uvs;
    std::vector<std::uint32_t> m_indices;  // from the primitive's first vertex
    std::vector<LastVertex> m_last;        // one a position of the mesh that is added
};

}  // namespace rubble
