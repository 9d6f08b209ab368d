#pragma once

#include "core/geometry/Vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// Which material a face carries: the asset's outside, or the inside that a cut lays open.
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
    std::uint32_t normal = 0;    // flat: one for the whole face
    std::uint32_t material = 0;  // outside faces: index of the source mesh's material; 0 otherwise
    FaceSide side = FaceSide::Outside;
};

/// A surface for drawing and export. Outside faces come before inside faces.
struct Mesh {
    std::vector<Vec3> positions;  // m
    std::vector<Vec2> uvs;
    std::vector<Vec3> normals;  // length 1
    std::vector<MeshCorner> corners;
    std::vector<MeshFace> faces;

    std::span<const MeshCorner> cornersOf(const MeshFace& face) const {
        return std::span(corners).subspan(face.firstCorner, face.cornerCount);
    }
};

/// The volume inside a closed mesh, m^3; negative where its faces look inward.
double volumeOf(const Mesh& mesh);

/// The same surface in triangles. A face across the z axis (a prism's cap) of four or more corners is cut from a new
/// vertex at its centre, any other along diagonals from its first corner. Faces are convex.
/// Source: the thesis, 4.3.
Mesh triangulated(const Mesh& mesh);

/// Says what is wrong: an index out of range, a face of fewer than three corners, a normal that is not of length 1 or
/// does not fit its face, an inside face before an outside one, an edge that has not exactly two faces running along
/// it in opposite ways, a volume other than `volume` (relative 1e-9). Nothing where all is well.
std::optional<std::string> verifyMesh(const Mesh& mesh, double volume);

}  // namespace rubble
