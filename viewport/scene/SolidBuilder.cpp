#include "viewport/scene/SolidBuilder.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kUsualCorners = 16;  // of a face

constexpr std::uint8_t kOnEdge = 0, kOnOppositeEdge = 255, kAway = 128;

}  // namespace

SolidBuilder::SolidBuilder(SceneGeometry& geometry, double size)
    : m_geometry(geometry), m_solid(geometry.solidCount()), m_size(static_cast<float>(size)) {
    geometry.boxes.emplace_back();
    geometry.firstIndices.push_back(static_cast<std::uint32_t>(geometry.indices.size()));
    m_corners.reserve(kUsualCorners);
    m_isEdge.reserve(kUsualCorners);
}

void SolidBuilder::beginFace(Vec3 normal, VertexSide side) {
    m_like.normal = glm::vec3(normal);
    m_like.side = side;
    m_like.solid = m_solid;
    m_corners.clear();
    m_isEdge.clear();
}

void SolidBuilder::addCorner(Vec3 position, Vec2 uv, bool isEdge, const std::optional<Vec3>& normal) {
    m_geometry.boxes.back().include(position);
    SceneVertex vertex = m_like;
    vertex.position = glm::vec3(position);
    vertex.uv = glm::vec2(uv);
    if (normal) vertex.normal = glm::vec3(*normal);
    m_corners.push_back(vertex);
    m_isEdge.push_back(isEdge);
}

void SolidBuilder::endFace() {
    const bool areAllEdges = std::ranges::find(m_isEdge, false) == m_isEdge.end();
    if (areAllEdges && m_corners.size() == 4) return addQuad();
    if (!areAllEdges && m_corners.size() == 3) return addTriangleWithHiddenEdges();
    areAllEdges ? addFan() : addFanWithHiddenEdges();
}

std::uint32_t SolidBuilder::add(SceneVertex vertex, std::uint8_t s, std::uint8_t t) {
    vertex.across = {s, t};
    m_geometry.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(m_geometry.vertices.size() - 1);
}

void SolidBuilder::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    m_geometry.indices.insert(m_geometry.indices.end(), {a, b, c});
}

void SolidBuilder::addQuad() {
    const std::uint32_t first = add(m_corners[0], kOnEdge, kOnEdge);
    add(m_corners[1], kOnOppositeEdge, kOnEdge);
    add(m_corners[2], kOnOppositeEdge, kOnOppositeEdge);
    add(m_corners[3], kOnEdge, kOnOppositeEdge);
    addTriangle(first, first + 1, first + 2);
    addTriangle(first, first + 2, first + 3);
}

/// The place across of a corner that is opposite to an edge. Lines fade on faces that are narrow on the screen, but
/// what is narrow here is only a triangle of a wider face.
std::uint8_t SolidBuilder::away(const glm::vec3& corner, const glm::vec3& from, const glm::vec3& to) const {
    constexpr float kWidest = 0.25f;  // of the size
    const float length = glm::distance(from, to);
    if (m_size <= 0.0f || length <= 0.0f) return kAway;
    const float height = glm::length(glm::cross(to - from, corner - from)) / length;
    return static_cast<std::uint8_t>(std::clamp(kAway * height / (kWidest * m_size), 1.0f, float{kAway}));
}

/// Has at most two visible edges: one per direction of SceneVertex::across.
void SolidBuilder::addTriangleWithHiddenEdges() {
    const std::size_t hidden = static_cast<std::size_t>(std::ranges::find(m_isEdge, false) - m_isEdge.begin());
    const std::size_t start = (hidden + 1) % 3, middle = (hidden + 2) % 3;
    const std::uint8_t s = m_isEdge[start] ? kOnEdge : kAway, t = m_isEdge[middle] ? kOnEdge : kAway;
    const glm::vec3 &a = m_corners[start].position, &b = m_corners[middle].position, &c = m_corners[hidden].position;
    const std::uint32_t first = add(m_corners[start], s, m_isEdge[middle] ? away(a, b, c) : kAway);
    add(m_corners[middle], s, t);
    add(m_corners[hidden], m_isEdge[start] ? away(c, a, b) : kAway, t);
    addTriangle(first, first + 1, first + 2);
}

SceneVertex SolidBuilder::centre() const {
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

/// A fan around the centre: each triangle has one edge of the face.
void SolidBuilder::addFan() {
    const auto count = static_cast<std::uint32_t>(m_corners.size());
    const std::uint32_t middle = add(centre(), kAway, kAway);
    for (const SceneVertex& corner : m_corners) add(corner, kOnEdge, kAway);
    for (std::uint32_t k = 0; k < count; ++k) addTriangle(middle, middle + 1 + k, middle + 1 + (k + 1) % count);
}

/// The same with hidden edges: the triangles share no corners.
void SolidBuilder::addFanWithHiddenEdges() {
    const SceneVertex middle = centre();
    for (std::size_t k = 0; k < m_corners.size(); ++k) {
        const std::uint8_t s = m_isEdge[k] ? kOnEdge : kAway;
        const SceneVertex &from = m_corners[k], &to = m_corners[(k + 1) % m_corners.size()];
        const std::uint8_t far = m_isEdge[k] ? away(middle.position, from.position, to.position) : kAway;
        const std::uint32_t first = add(middle, far, kAway);
        add(from, s, kAway);
        add(to, s, kAway);
        addTriangle(first, first + 1, first + 2);
    }
}

}  // namespace rubble
