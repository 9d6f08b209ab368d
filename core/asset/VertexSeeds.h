#pragma once

#include "core/fracture/PlacedSeeds.h"
#include "core/geometry/Polygon.h"
#include "core/geometry/SourceScene.h"

#include <optional>

namespace rubble {

enum class FileAxis { X, Y, Z };

/// How a mesh is laid on an outline to give it seeds.
struct VertexView {
    FileAxis along = FileAxis::Z;  // looked at against it; X and Y keep y and x upright as the sides of a cube do
    std::optional<double> metresPerUnit;  // instead of what the file says, or metres
    bool isFitted = false;  // scaled evenly and moved until its bounds stand in the middle of the outline's
};

/// Seeds where a mesh has points.
struct VertexSeeds {
    PlacedSeeds seeds;             // in the order of the points
    std::uint32_t outside = 0;     // points that were left out: beyond the outline,
    std::uint32_t duplicates = 0;  // or, seen along the axis, where another one is
    /// What was left out, in a sentence; empty where nothing was.
    std::string report() const;
};

/// The points of all objects of a mesh file, seen along one of its axes: unless it is fitted, its origin is that of the
/// prism.
///
/// Errors: BadInput where the unit is not finite and above zero; Degenerate where no point lies in the outline; Limit above
/// kMostSeeds.
Result<VertexSeeds> seedsAtVertices(const SourceScene& mesh, const VertexView& view, const Polygon& outline);

}  // namespace rubble
