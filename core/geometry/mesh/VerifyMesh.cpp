#include "core/base/MessageText.h"
#include "core/geometry/mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {

namespace {

using Fault = std::optional<std::string>;

constexpr double kRelativeVolume = 1e-9;
constexpr double kUnitLength = 1e-9;
constexpr double kNormalTolerance =
    1e-6;  // sine of the angle between a face and its normal; tolerant enough for needles

std::string name(std::size_t face) { return "Face " + std::to_string(face); }

Fault faceFault(const Mesh& mesh, std::size_t index) {
    const MeshFace& face = mesh.faces[index];
    if (face.cornerCount < 3) return name(index) + " has fewer than three corners.";
    if (face.firstCorner + std::size_t{face.cornerCount} > mesh.corners.size()) return name(index) + " lacks corners.";
    if (face.normal >= mesh.normals.size()) return name(index) + " has no normal.";
    for (const MeshCorner corner : mesh.cornersOf(face)) {
        if (corner.position >= mesh.positions.size()) return name(index) + " has a corner without a position.";
        if (corner.uv >= mesh.uvs.size()) return name(index) + " has a corner without texture coordinates.";
    }
    return std::nullopt;
}

/// The area vector of a face times two, by a triangle fan.
Vec3 areaVector(const Mesh& mesh, const MeshFace& face) {
    const std::span<const MeshCorner> corners = mesh.cornersOf(face);
    const Vec3 origin = mesh.positions[corners[0].position];
    Vec3 sum{0.0, 0.0, 0.0};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        sum +=
            glm::cross(mesh.positions[corners[k].position] - origin, mesh.positions[corners[k + 1].position] - origin);
    }
    return sum;
}

/// By how much twice the area of a face may be wrong, m², if its corners are rounded: needles have no orientation.
/// The lattice on which closed meshes are cut has a step of up to 2⁻³⁹ of their diagonal; four count as none.
double areaSlack(const Mesh& mesh, const MeshFace& face, double extent) {
    constexpr double kRounding = 1e-11;  // of the mesh's extent
    const std::span<const MeshCorner> corners = mesh.cornersOf(face);
    double longest = 0.0;
    for (const MeshCorner& corner : corners) {
        longest =
            std::max(longest, glm::distance(mesh.positions[corner.position], mesh.positions[corners[0].position]));
    }
    return kRounding * extent * longest;
}

Fault normalFault(const Mesh& mesh, std::size_t index, double extent) {
    const Vec3 normal = mesh.normals[mesh.faces[index].normal];
    if (!(std::abs(glm::length(normal) - 1.0) < kUnitLength)) return name(index) + " has a normal not of length 1.";
    const Vec3 area = areaVector(mesh, mesh.faces[index]);
    const double slack = areaSlack(mesh, mesh.faces[index], extent);
    const double skew = glm::length(glm::cross(area, normal));
    if (glm::dot(area, normal) > -slack && skew <= kNormalTolerance * glm::length(area) + slack) return std::nullopt;
    return name(index) + " is not counter-clockwise about its normal.";
}

/// Every edge must be used once in each direction.
Fault closureFault(const Mesh& mesh) {
    using EdgeEnds = std::array<std::uint32_t, 2>;
    std::vector<EdgeEnds> runs;
    runs.reserve(mesh.corners.size());
    for (const MeshFace& face : mesh.faces) {
        const std::span<const MeshCorner> corners = mesh.cornersOf(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            runs.push_back({corners[k].position, corners[(k + 1) % corners.size()].position});
        }
    }
    std::sort(runs.begin(), runs.end());
    const auto edge = [](EdgeEnds ends) { return "Edge " + std::to_string(ends[0]) + "-" + std::to_string(ends[1]); };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (i > 0 && runs[i] == runs[i - 1]) return edge(runs[i]) + " is used twice in the same direction.";
        if (!std::binary_search(runs.begin(), runs.end(), EdgeEnds{runs[i][1], runs[i][0]}))
            return edge(runs[i]) + " is open.";
    }
    return std::nullopt;
}

Fault orderFault(const Mesh& mesh) {
    for (std::size_t i = 1; i < mesh.faces.size(); ++i) {
        if (mesh.faces[i - 1].side == FaceSide::Inside && mesh.faces[i].side == FaceSide::Outside) {
            return name(i) + " is an outside face after an inside one.";
        }
    }
    return std::nullopt;
}

}  // namespace

Fault verifyMesh(const Mesh& mesh, double volume, double cutFrom) {
    double extent = cutFrom;
    for (const Vec3& position : mesh.positions) extent = std::max(extent, glm::length(position));
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (Fault fault = faceFault(mesh, i)) return fault;
        if (Fault fault = normalFault(mesh, i, extent)) return fault;
    }
    if (Fault fault = orderFault(mesh)) return fault;
    if (Fault fault = closureFault(mesh)) return fault;
    const double found = volumeOf(mesh);
    if (std::abs(found - volume) <= kRelativeVolume * std::abs(volume)) return std::nullopt;
    return "The volume is " + messageText(found) + " instead of " + messageText(volume) + ".";
}

}  // namespace rubble
