#include "core/asset/texture/SurfaceChart.h"

#include "core/geometry/mesh/FaceNeighbours.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr double kMinCosine = 0.8;           // of 37 degrees: what is projected is at most 1.25 times as long
constexpr double kPlanarCosine = 1 - 1e-13;  // of a tilt by which nothing moves that can be seen

/// The direction of the longest edge of a face, in its plane.
Vec3 longestEdge(const Mesh& mesh, const MeshFace& face) {
    const std::span<const MeshCorner> corners = mesh.cornersOf(face);
    Vec3 longest(0.0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 edge =
            mesh.positions[corners[(k + 1) % corners.size()].position] - mesh.positions[corners[k].position];
        if (glm::dot(edge, edge) > glm::dot(longest, longest)) longest = edge;
    }
    return longest;
}

/// Sets the axes of a chart: u is as near to a direction as it can be.
void setAxes(SurfaceChart& chart, Vec3 normal, Vec3 direction) {
    chart.normal = normal;
    const Vec3 along = direction - normal * glm::dot(direction, normal);
    const double length = glm::length(along);
    const Vec3 size = glm::abs(normal);
    const Vec3 other = size.x <= size.y && size.x <= size.z ? Vec3(1.0, 0.0, 0.0)
                       : size.y <= size.z                   ? Vec3(0.0, 1.0, 0.0)
                                                            : Vec3(0.0, 0.0, 1.0);
    chart.across = length > 1e-12 ? along / length : glm::normalize(other - normal * glm::dot(other, normal));
    chart.upwards = glm::cross(chart.normal, chart.across);
}

/// Adds the faces of a group to a chart whose axes are set.
void addFaces(SurfaceChart& chart, const Mesh& mesh, Vec3 offset, std::span<const std::uint32_t> group) {
    chart.low = Vec2(std::numeric_limits<double>::max());
    chart.high = -chart.low;
    bool isPlanar = true;
    for (const std::uint32_t f : group) {
        const MeshFace& face = mesh.faces[f];
        ChartFace added{.normal = mesh.normals[face.normal], .shape = {}};
        for (const MeshCorner corner : mesh.cornersOf(face)) {
            const Vec3 point = mesh.positions[corner.position] + offset;
            added.distance += glm::dot(point, added.normal) / face.cornerCount;
            added.shape.push_back(chart.coordinatesOf(point));
            chart.low = glm::min(chart.low, added.shape.back());
            chart.high = glm::max(chart.high, added.shape.back());
        }
        isPlanar = isPlanar && glm::dot(added.normal, chart.normal) >= kPlanarCosine;
        chart.faces.push_back(std::move(added));
    }
    if (!isPlanar) return;
    chart.faces.resize(1);
    chart.faces[0].shape.clear();
}

}  // namespace

Vec3 SurfaceChart::pointAt(Vec2 coordinates, const ChartFace& face) const {
    const Vec3 inPlane = coordinates.x * across + coordinates.y * upwards;
    return inPlane + normal * ((face.distance - glm::dot(inPlane, face.normal)) / glm::dot(normal, face.normal));
}

Vec3 SurfaceChart::tangentOf(Vec3 faceNormal) const { return glm::normalize(glm::cross(upwards, faceNormal)); }

MeshCharts chartsOf(const Mesh& mesh, Vec3 offset, TexturedSides sides) {
    MeshCharts result;
    result.ofFaces.assign(mesh.faces.size(), MeshCharts::kNoChart);
    const FaceNeighbours neighbours(mesh);
    std::vector<std::uint32_t> group;
    for (std::uint32_t first = 0; first < mesh.faces.size(); ++first) {
        const MeshFace& seed = mesh.faces[first];
        if (!sides.has(seed.side) || result.ofFaces[first] != MeshCharts::kNoChart) continue;
        const Vec3 normal = mesh.normals[seed.normal];
        const auto number = static_cast<std::uint32_t>(result.charts.size());
        group.assign(1, first);
        result.ofFaces[first] = number;
        for (std::size_t k = 0; k < group.size(); ++k) {
            neighbours.forEachAround(mesh, group[k], [&](std::uint32_t next) {
                const MeshFace& face = mesh.faces[next];
                if (face.side != seed.side || result.ofFaces[next] != MeshCharts::kNoChart) return;
                if (glm::dot(mesh.normals[face.normal], normal) < kMinCosine) return;
                result.ofFaces[next] = number;
                group.push_back(next);
            });
        }
        SurfaceChart& chart = result.charts.emplace_back();
        chart.side = seed.side == FaceSide::Outside ? FinishSide::Outside : FinishSide::Inside;
        setAxes(chart, normal, longestEdge(mesh, seed));
        addFaces(chart, mesh, offset, group);
        result.groups.push_back(group);
    }
    return result;
}

}  // namespace rubble
