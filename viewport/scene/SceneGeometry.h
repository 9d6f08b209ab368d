#pragma once

#include "core/asset/project/Texture.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/Mesh.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// What gives a vertex its colour. Textured: on the outside, with the image of its batch. Mortar: that of mortar.
enum class VertexSide : std::uint8_t { Outside, Inside, Textured, Mortar };

/// A vertex as uploaded to the GPU. Faces are flat and share no vertices.
struct SceneVertex {
    glm::vec3 position{0.0f};  // m, in the solid's own frame
    glm::vec3 normal{0.0f};    // length 1
    glm::vec2 uv{0.0f};
    std::uint32_t solid = 0;  // index in SceneGeometry::boxes; the shaders look up pose and colours by it

    /// Position across the face in two directions: 0 and 255 on visible edges, 128 away from them. From the
    /// interpolated values the fragment shader computes the distance to the nearest edge, so that edges need no line
    /// geometry.
    std::array<std::uint8_t, 2> across{128, 128};
    VertexSide side = VertexSide::Outside;
    std::uint8_t sizeCode = 0;  // of the solid's bounding box: a diagonal of 2^((sizeCode - 128) / 8) m
};

/// A range of SceneGeometry::indices: whole triangles.
struct TriangleRange {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
};

/// The triangles of many solids, immutable and shared by all instances of an asset; poses, visibility and colours are
/// in RenderScene.
///
/// They may begin with those of the whole that the other solids are cut from, all that is drawn of an instance that is
/// intact. It is solid 0, hidden while its fragments are shown, or a double of all solids in the frame of solid 0.
struct SceneGeometry {
    enum class Whole { None, Solid, Double };

    std::vector<SceneVertex> vertices;
    std::vector<std::uint32_t> indices;       // three per triangle, counter-clockwise from outside
    std::vector<Box3> boxes;                  // bounding box of each solid, in its own frame
    std::vector<std::uint32_t> firstIndices;  // of each solid, whose triangles follow one another
    Whole whole = Whole::None;
    TriangleRange wholeIndices;
    TriangleRange silhouetteIndices;  // of a whole without the joints between its fragments
    Box3 wholeBox;                    // in the frame of solid 0

    std::uint32_t solidCount() const { return static_cast<std::uint32_t>(boxes.size()); }
    TriangleRange indicesOf(std::uint32_t solid) const {
        return {firstIndices[solid], solid + 1 < solidCount() ? firstIndices[solid + 1] : indices.size()};
    }
    /// All that is drawn where the solids are not drawn as a whole.
    TriangleRange partIndices() const { return {wholeIndices.end, indices.size()}; }
    /// The mean diagonal of the parts' boxes, m.
    double meanPartSize() const;
};

/// The one solid that has been added so far is no solid, but what is seen of the whole of those that follow without the
/// joints between them. `whole`: None if the whole follows.
void endSilhouette(SceneGeometry& geometry, SceneGeometry::Whole whole);
/// The one solid that has been added so far is the whole of those that follow.
void endWhole(SceneGeometry& geometry);

/// A convex face without visible edges.
struct PlainFace {
    Vec3 normal{0.0, 0.0, 1.0};  // length 1
    std::vector<Vec3> corners;   // m, counter-clockwise from outside
};

/// A part of a solid: a mesh, and the mortar around it.
struct SolidPart {
    Mesh mesh;
    std::vector<PlainFace> mortar;
    bool isRough = false;  // its cuts are: strips with bends, which are drawn as one surface
};

/// Appends a solid with the faces of several parts, or of several hulls; the faces are convex. Edges between coplanar
/// faces of a mesh (the convex parts of a cap) are hidden, and those of its outside that bend by less than 30 degrees
/// (triangles of a curved surface); those of rough cuts as well that bend by less than 60 degrees, across which normals
/// change gradually.
/// `texture`: of the outside of meshes; null: none.
void addSolid(SceneGeometry& geometry, std::span<const SolidPart> parts, const Texture* texture = nullptr);
void addSolid(SceneGeometry& geometry, std::span<const Polytope> hulls);

}  // namespace rubble
