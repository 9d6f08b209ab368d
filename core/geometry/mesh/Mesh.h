#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// Whether a face is on the asset's outside or on the inside exposed by a cut.
enum class FaceSide : std::uint8_t { Outside, Inside };

/// A corner of a face.
struct MeshCorner {
    std::uint32_t position = 0;
    std::uint32_t uv = 0;
};

/// A planar n-gon, counter-clockwise from outside: corners [firstCorner, firstCorner + cornerCount).
struct MeshFace {
    std::uint32_t firstCorner = 0;
    std::uint32_t cornerCount = 0;
    std::uint32_t normal = 0;    // flat shading: one per face
    std::uint32_t material = 0;  // outside faces: index of the source mesh's material; 0 otherwise
    FaceSide side = FaceSide::Outside;
};

/// A polygon mesh for drawing and export. Outside faces precede inside faces.
struct Mesh {
    std::vector<Vec3> positions;  // m
    std::vector<Vec2> uvs;
    std::vector<Vec3> normals;  // length 1
    std::vector<MeshCorner> corners;
    std::vector<MeshFace> faces;
    /// One per face, where there are any: the direction in which u grows, of length 1 and across the normal; w is the
    /// sign of the direction in which v grows, across both.
    std::vector<glm::dvec4> tangents;

    std::span<const MeshCorner> cornersOf(const MeshFace& face) const {
        return std::span(corners).subspan(face.firstCorner, face.cornerCount);
    }
};

/// The volume of a closed mesh, m³; negative if its faces point inward.
double volumeOf(const Mesh& mesh);

/// The triangulated mesh. A face perpendicular to the z axis (a prism's cap) with four or more corners becomes a fan
/// around a new vertex at its centre, any other face a fan from its first corner. Faces must be convex.
/// Source: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor thesis), 4.3.
Mesh triangulated(const Mesh& mesh);

/// Why a mesh is invalid: an index out of range, a face with fewer than three corners, a normal that is not of length 1
/// or does not match its face (of a needle, which is as thin as rounding, that is not checked), an inside face before
/// an outside one, an edge without exactly two faces in opposite directions, or a volume other than `volume` (relative
/// 1e-9). Nothing for a valid one.
/// `cutFrom`: the extent, m, of the closed mesh that it was cut from on a lattice, which its points are rounded to; 0:
/// it was cut from none.
std::optional<std::string> verifyMesh(const Mesh& mesh, double volume, double cutFrom = 0.0);

}  // namespace rubble
