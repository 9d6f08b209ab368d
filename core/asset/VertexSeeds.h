#pragma once

#include "core/fracture/PlacedSeeds.h"
#include "core/geometry/Polygon.h"
#include "core/geometry/SourceScene.h"

namespace rubble {

/// Seeds where a mesh has points.
struct VertexSeeds {
    PlacedSeeds seeds;             // in the order of the points
    std::uint32_t outside = 0;     // points that were left out: beyond the outline,
    std::uint32_t duplicates = 0;  // or, seen along the prism's axis, where another one is
    /// What was left out, in a sentence; empty where nothing was.
    std::string report() const;
};

/// The points of all objects of a mesh file, seen along the z axis of the prism: the mesh stands in the prism's frame, `scale` metres
/// a unit.
///
/// Errors: BadInput where the scale is not finite and above zero; Degenerate where no point lies in the outline; Limit above
/// kMostSeeds.
Result<VertexSeeds> seedsAtVertices(const SourceScene& mesh, double scale, const Polygon& outline);

}  // namespace rubble
