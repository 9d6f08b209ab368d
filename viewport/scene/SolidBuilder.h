#pragma once

#include "viewport/scene/SceneGeometry.h"

#include <optional>
#include <vector>

namespace rubble {

/// Appends one solid to a geometry, face by face. Faces are convex.
class SolidBuilder {
public:
    /// `size`: m, the diagonal of the solid's box. Faces with hidden edges are parts of wider ones: they are given the
    /// width of these, at most a quarter of the size. 0: that of their own.
    explicit SolidBuilder(SceneGeometry& geometry, double size = 0.0);

    /// Begins a face; its corners follow.
    void beginFace(Vec3 normal, VertexSide side);
    /// `isEdge`: the edge to the next corner is visible.
    /// `normal`: where it is not that of the face.
    void addCorner(Vec3 position, Vec2 uv, bool isEdge, const std::optional<Vec3>& normal = {});
    void endFace();

private:
    std::uint32_t add(SceneVertex vertex, std::uint8_t s, std::uint8_t t);
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void addQuad();
    void addTriangleWithHiddenEdges();
    std::uint8_t away(const glm::vec3& corner, const glm::vec3& from, const glm::vec3& to) const;
    SceneVertex centre() const;
    void addFan();
    void addFanWithHiddenEdges();

    SceneGeometry& m_geometry;
    std::uint32_t m_solid;
    float m_size;        // m
    SceneVertex m_like;  // what all corners of the face have in common
    std::vector<SceneVertex> m_corners;
    std::vector<bool> m_isEdge;
};

}  // namespace rubble
