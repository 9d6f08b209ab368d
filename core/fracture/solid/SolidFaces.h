#pragma once

#include "core/fracture/solid/FaceTriangulation.h"
#include "core/fracture/solid/InnerFaces.h"
#include "core/fracture/solid/SolidPartition.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The faces of all cells in a solid. In place of fragments, the sides of faces have cells.
struct SolidFaces {
    std::vector<SolidPartition::Face> faces;
    std::vector<std::uint32_t> firstTriangle = {0};  // faces + 1
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> firstLoop = {0};  // faces + 1
    std::vector<PointLoop> loops;                // of each face, the outer one first

    std::span<const std::array<std::uint32_t, 3>> trianglesOf(std::uint32_t face) const {
        return std::span(triangles).subspan(firstTriangle[face], firstTriangle[face + 1] - firstTriangle[face]);
    }
};

/// Makes the faces of the pieces of a surface and of the facets inside it. Points that coincide become one, and what
/// has no area or no thickness because of ties is left out, so that the rest fits together.
SolidFaces solidFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                      const InnerFaces& facets, std::span<const Vec3> points);

}  // namespace rubble
