#pragma once

#include "viewport/scene/SceneGeometry.h"

#include <vector>

namespace rubble {

/// Appends one solid to a geometry, face by face. Faces are convex.
class SolidBuilder {
public:
    explicit SolidBuilder(SceneGeometry& geometry);

    /// Begins a face; its corners follow.
    void beginFace(Vec3 normal, VertexSide side);
    /// `isEdge`: the edge to the next corner is visible.
    void addCorner(Vec3 position, Vec2 uv, bool isEdge);
    void endFace();

private:
    std::uint32_t add(SceneVertex vertex, std::uint8_t s, std::uint8_t t);
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void addQuad();
    void addTriangleWithHiddenEdges();
    SceneVertex centre() const;
    void addFan();
    void addFanWithHiddenEdges();

    SceneGeometry& m_geometry;
    std::uint32_t m_solid;
    SceneVertex m_like;  // what all corners of the face have in common
    std::vector<SceneVertex> m_corners;
    std::vector<bool> m_isEdge;
};

}  // namespace rubble
