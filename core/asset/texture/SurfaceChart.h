#pragma once

#include "core/asset/finish/FinishParameters.h"
#include "core/geometry/mesh/Mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A plane that faces of a chart lie in, and one of these faces, as seen along the normal of the chart.
struct ChartFace {
    Vec3 normal;              // length 1
    double distance = 0.0;    // m, of the plane from the asset's origin
    std::vector<Vec2> shape;  // convex, counter-clockwise, in the chart's coordinates; empty: the whole chart
};

/// Faces that are projected into a plane, which become a rectangle of a texture. Lengths in metres, in the asset's
/// frame.
struct SurfaceChart {
    FinishSide side = FinishSide::Outside;
    Vec3 normal{0.0, 0.0, 1.0};   // length 1, as the next two: across them
    Vec3 across{1.0, 0.0, 0.0};   // the direction of u
    Vec3 upwards{0.0, 1.0, 0.0};  // the direction of v
    Vec2 low{0.0}, high{0.0};     // the extent of its faces in these directions
    std::vector<ChartFace> faces;

    bool isPlanar() const { return faces.size() == 1; }
    Vec2 coordinatesOf(Vec3 point) const { return {glm::dot(point, across), glm::dot(point, upwards)}; }
    /// The point of the plane of one of its faces that is projected to some coordinates.
    Vec3 pointAt(Vec2 coordinates, const ChartFace& face) const;
    /// The direction on one of its faces in which u grows and v stays, of length 1.
    Vec3 tangentOf(Vec3 faceNormal) const;
};

/// Which sides of meshes have textures.
struct TexturedSides {
    bool outside = true;
    bool inside = true;
    bool has(FaceSide side) const { return side == FaceSide::Outside ? outside : inside; }
};

/// The charts of a mesh with their faces, and for each face the index of its chart; kNoChart for those without a
/// texture.
struct MeshCharts {
    static constexpr std::uint32_t kNoChart = 0xffffffff;
    std::vector<SurfaceChart> charts;
    std::vector<std::vector<std::uint32_t>> groups;  // the faces of each chart
    std::vector<std::uint32_t> ofFaces;
};

/// Groups the faces of a mesh at `offset` in the frame of its asset: connected faces of one side whose normals differ
/// by less than 37 degrees from that of the first of them, onto whose plane all are projected. O(n log n).
MeshCharts chartsOf(const Mesh& mesh, Vec3 offset, TexturedSides sides);

}  // namespace rubble
