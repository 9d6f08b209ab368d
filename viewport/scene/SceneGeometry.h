#pragma once

#include "core/geometry/Mesh.h"
#include "core/geometry/Polytope.h"
#include "core/geometry/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// A corner as a graphics card takes it. Flat: corners are not shared between faces.
struct SceneVertex {
    glm::vec3 position{0.0f};  // m, in the piece's own frame
    glm::vec3 normal{0.0f};    // length 1
    glm::vec2 uv{0.0f};
    std::uint32_t piece = 0;  // index in SceneGeometry::boxes; moves and colours are looked up by it

    /// Where the corner lies across its face, in two directions: 0 and 255 at the face's edges, 128 away from them. What is
    /// interpolated tells a pixel how far the next edge is, so that edges need no lines of their own.
    std::array<std::uint8_t, 2> across{128, 128};
    FaceSide side = FaceSide::Outside;
    std::uint8_t unused = 0;
};

/// The triangles of many pieces, shared by all instances of an asset and never changed: what moves, hides or colours a
/// piece is told beside it (see RenderScene).
struct SceneGeometry {
    std::vector<SceneVertex> vertices;
    std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise from outside
    std::vector<Box3> boxes;             // around each piece, in its own frame

    std::uint32_t pieceCount() const { return static_cast<std::uint32_t>(boxes.size()); }
};

/// Appends a piece with the faces of a mesh, or of several hulls. Edges between faces of one plane (the convex parts of a
/// cap) do not show as edges. Faces are convex.
void addPiece(SceneGeometry& geometry, const Mesh& mesh);
void addPiece(SceneGeometry& geometry, std::span<const Polytope> hulls);

}  // namespace rubble
