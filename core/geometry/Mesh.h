#pragma once

#include "core/geometry/Vec.h"

#include <cstdint>
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
};

}  // namespace rubble
