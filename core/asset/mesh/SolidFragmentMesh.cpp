#include "core/asset/mesh/SolidFragmentMesh.h"

#include "core/base/Index.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A position in a face's plane, seen along the axis nearest to its normal, from outside.
Vec2 planeUv(Vec3 position, Vec3 normal) {
    const Vec3 size = glm::abs(normal);
    if (size.z >= size.x && size.z >= size.y) return {normal.z > 0.0 ? position.x : -position.x, position.y};
    if (size.x >= size.y) return {normal.x > 0.0 ? -position.z : position.z, position.y};
    return {position.x, normal.y > 0.0 ? -position.z : position.z};
}

/// Adds flat faces of triangles to a mesh; each face has UVs of its own.
class SolidMeshBuilder {
public:
    /// `offset`: added to positions for UVs, so that those of neighbours agree.
    SolidMeshBuilder(const std::vector<Vec3>& points, Vec3 centre, Vec3 offset)
        : m_points(points), m_centre(centre), m_offset(offset), m_indices(points.size(), kNone) {}

    void addFace(std::span<const Triangle> triangles, bool isReversed, FaceSide side, double uvScale) {
        Vec3 area{0.0};
        for (const Triangle& triangle : triangles) {
            const Vec3 a = m_points[triangle[0]];
            area += glm::cross(m_points[triangle[1]] - a, m_points[triangle[2]] - a);
        }
        const double length = glm::length(area);
        Vec3 normal = length > 0.0 ? area / length : Vec3{0.0, 0.0, 1.0};
        if (isReversed) normal = -normal;
        m_mesh.normals.push_back(normal);
        const auto normalIndex = static_cast<std::uint32_t>(m_mesh.normals.size() - 1);
        for (Triangle triangle : triangles) {
            if (isReversed) std::swap(triangle[1], triangle[2]);
            m_mesh.faces.push_back({static_cast<std::uint32_t>(m_mesh.corners.size()), 3, normalIndex, 0, side});
            for (const std::uint32_t point : triangle) addCorner(point, normal, uvScale);
        }
    }

    Mesh result() && { return std::move(m_mesh); }

private:
    void addCorner(std::uint32_t point, Vec3 normal, double uvScale) {
        if (m_indices[point] == kNone) {
            m_indices[point] = static_cast<std::uint32_t>(m_mesh.positions.size());
            m_mesh.positions.push_back(m_points[point] - m_centre);
        }
        const auto uv = static_cast<std::uint32_t>(m_mesh.uvs.size());
        m_mesh.uvs.push_back(uvScale * planeUv(m_points[point] + m_offset, normal));
        m_mesh.corners.push_back({m_indices[point], uv});
    }

    const std::vector<Vec3>& m_points;
    const Vec3 m_centre;
    const Vec3 m_offset;
    std::vector<std::uint32_t> m_indices;  // of each point, in the mesh; kNone: not yet there
    Mesh m_mesh;
};

/// The mesh of a fragment less a gap. Triangles of one side that follow each other in one plane are a face.
Mesh shrunkMesh(const ShrunkFragment& fragment, Vec3 centre, Vec3 origin, const Asset& asset) {
    constexpr double kFlat = 1e-10;  // radians between normals: less than meshes are verified to
    const std::vector<Triangle>& triangles = fragment.mesh.triangles;
    const auto normalOf = [&](std::size_t k) {
        const Vec3 normal = doubleArea(fragment.mesh, k);
        const double length = glm::length(normal);
        return length > 0.0 ? normal / length : Vec3(0.0);
    };
    SolidMeshBuilder builder(fragment.mesh.points, centre, origin);
    for (const FaceSide side : {FaceSide::Outside, FaceSide::Inside}) {
        for (std::size_t first = 0, end = 0; first < triangles.size(); first = end) {
            const ShrunkFragment::Side& one = fragment.sides[first];
            const Vec3 normal = normalOf(first);
            for (end = first + 1; end < triangles.size(); ++end) {
                const ShrunkFragment::Side& next = fragment.sides[end];
                const bool isOfSide = next.neighbour == one.neighbour && next.source == one.source;
                if (!isOfSide || glm::distance(normalOf(end), normal) > kFlat) break;
            }
            const bool isOutside = one.neighbour == kNone;
            if (isOutside != (side == FaceSide::Outside)) continue;
            builder.addFace(std::span(triangles).subspan(first, end - first), false, side,
                            isOutside ? 1.0 : asset.insideUvScale);
        }
    }
    return std::move(builder).result();
}

}  // namespace

Mesh solidFragmentMesh(const Fragment& fragment, const Asset& asset) {
    const SolidFragments& all = *fragment.all().solid();
    const SolidPartition& partition = all.partition;
    const Vec3 origin = partition.origin + fragment.all().origin, centre = all.masses[fragment.index()].centre;
    const std::uint32_t number = all.numberInPartition(fragment.index());
    if (all.shrunk) return shrunkMesh(all.shrunk->fragments[number], centre, origin, asset);
    SolidMeshBuilder builder(partition.points, centre, origin);
    for (const FaceSide side : {FaceSide::Outside, FaceSide::Inside}) {
        for (const SolidPartition::FaceSide& one : partition.facesOf(number)) {
            const bool isOutside = partition.faces[one.face].behind == kNone;
            if (isOutside != (side == FaceSide::Outside)) continue;
            builder.addFace(partition.trianglesOf(one.face), one.isReversed, side,
                            isOutside ? 1.0 : asset.insideUvScale);
        }
    }
    return std::move(builder).result();
}

Mesh solidWholeMesh(const ClosedMesh& mesh, Vec3 centre) {
    SolidMeshBuilder builder(mesh.mesh.points, centre, Vec3{0.0});
    for (const Triangle& triangle : mesh.mesh.triangles)
        builder.addFace(std::span(&triangle, 1), false, FaceSide::Outside, 1.0);
    return std::move(builder).result();
}

}  // namespace rubble
