#include "core/geometry/mesh/Mesh.h"

#include <initializer_list>

namespace rubble {

namespace {

/// Adds a face with the normal, material, side and tangent of a face of `source`.
void addFace(Mesh& mesh, const Mesh& source, std::size_t like, std::initializer_list<MeshCorner> corners) {
    MeshFace face = source.faces[like];
    if (!source.tangents.empty()) mesh.tangents.push_back(source.tangents[like]);
    face.firstCorner = static_cast<std::uint32_t>(mesh.corners.size());
    face.cornerCount = static_cast<std::uint32_t>(corners.size());
    mesh.corners.insert(mesh.corners.end(), corners);
    mesh.faces.push_back(face);
}

/// Adds a vertex at the mean of the corners' positions and texture coordinates.
MeshCorner addCentre(Mesh& mesh, std::span<const MeshCorner> corners) {
    const MeshCorner centre{static_cast<std::uint32_t>(mesh.positions.size()),
                            static_cast<std::uint32_t>(mesh.uvs.size())};
    Vec3 position{0.0, 0.0, 0.0};
    Vec2 uv{0.0, 0.0};
    for (const MeshCorner corner : corners) {
        position += mesh.positions[corner.position];
        uv += mesh.uvs[corner.uv];
    }
    const auto count = static_cast<double>(corners.size());
    mesh.positions.push_back(position / count);
    mesh.uvs.push_back(uv / count);
    return centre;
}

bool isAcrossZ(Vec3 normal) { return normal.x == 0.0 && normal.y == 0.0; }

}  // namespace

double volumeOf(const Mesh& mesh) {
    if (mesh.positions.empty()) return 0.0;
    const Vec3 origin = mesh.positions[0];
    double sixVolumes = 0.0;
    for (const MeshFace& face : mesh.faces) {
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        const Vec3 a = mesh.positions[corners[0].position] - origin;
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const Vec3 b = mesh.positions[corners[k].position] - origin;
            const Vec3 c = mesh.positions[corners[k + 1].position] - origin;
            sixVolumes += glm::dot(a, glm::cross(b, c));
        }
    }
    return sixVolumes / 6.0;
}

Mesh triangulated(const Mesh& mesh) {
    Mesh result{mesh.positions, mesh.uvs, mesh.normals, {}, {}, {}};
    result.corners.reserve(3 * mesh.corners.size());
    result.faces.reserve(mesh.corners.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const MeshFace& face = mesh.faces[f];
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        if (corners.size() > 3 && isAcrossZ(mesh.normals[face.normal])) {
            const MeshCorner centre = addCentre(result, corners);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                addFace(result, mesh, f, {centre, corners[k], corners[(k + 1) % corners.size()]});
            }
        } else {
            for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
                addFace(result, mesh, f, {corners[0], corners[k], corners[k + 1]});
            }
        }
    }
    return result;
}

}  // namespace rubble
