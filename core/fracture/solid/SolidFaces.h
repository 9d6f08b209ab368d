#pragma once

#include "core/base/UninitializedVector.h"
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
    UninitializedVector<SolidPartition::Face> faces;
    UninitializedVector<std::uint32_t> firstTriangle = {0};  // faces + 1
    PointTriangles triangles;
    UninitializedVector<std::uint32_t> firstLoop = {0};    // faces + 1: the outer loop first
    UninitializedVector<std::uint32_t> firstCorner = {0};  // loops + 1
    UninitializedVector<std::uint32_t> corners;            // points
    std::vector<std::uint32_t> welded;                     // the point that stands for each point, as used in the faces

    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(faces.size()); }
    std::span<const std::uint32_t> loop(std::uint32_t index) const {
        return std::span(corners).subspan(firstCorner[index], firstCorner[index + 1] - firstCorner[index]);
    }
    std::span<const std::array<std::uint32_t, 3>> trianglesOf(std::uint32_t face) const {
        return std::span(triangles).subspan(firstTriangle[face], firstTriangle[face + 1] - firstTriangle[face]);
    }
};

/// Makes the faces of the pieces of a surface and of the facets inside it. Points that coincide become one, and what
/// has no area or no thickness because of ties is left out, so that the rest fits together. Threads share the work as
/// long as nothing has to be left out.
///
/// Errors: Cancelled.
Result<SolidFaces> solidFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                              const InnerFaces& facets, std::span<const Vec3> points, const TaskContext& task = {});

}  // namespace rubble
