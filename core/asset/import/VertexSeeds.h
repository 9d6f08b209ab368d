#pragma once

#include "core/fracture/kinds/PlacedSeeds.h"
#include "core/geometry/mesh/SourceScene.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>

namespace rubble {

enum class FileAxis { X, Y, Z };

/// The projection of the points of a mesh onto an outline.
struct VertexView {
    FileAxis along = FileAxis::Z;         // viewed against this axis; y stays upright for X and x for Y
    std::optional<double> metresPerUnit;  // overrides the unit of the file; without either: metres
    bool isFitted = false;                // scaled uniformly and centred to fit the outline's bounding box
};

/// Seeds at the points of a mesh.
struct VertexSeeds {
    PlacedSeeds seeds;             // in the order of the points
    std::uint32_t outside = 0;     // points omitted since they lie outside the outline
    std::uint32_t duplicates = 0;  // points omitted since another one projects to the same position
    /// The omitted points as a sentence; empty if there are none.
    std::string omissionText() const;
};

/// Projects the points of all objects of a mesh file along one of its axes. Unless fitted, the origins of file and
/// prism coincide.
///
/// Errors: BadInput if the unit is out of range; Degenerate if no point lies in the outline; Limit above
/// kMaxSeeds.
Result<VertexSeeds> seedsAtVertices(const SourceScene& mesh, const VertexView& view, const Polygon& outline);

}  // namespace rubble
