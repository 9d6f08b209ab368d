#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/pieces/Prism.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A prism and the seeds of its fracture pattern.
struct FractureInput {
    Prism prism;
    std::vector<Vec2> seeds;
    std::vector<Diagnostic> diagnostics = {};  // RepeatedPoint: what was left out of the rings
};

/// Reads {"outline":[[x,y],...], "holes":[[[x,y],...],...], "depth":d, "seeds":[[x,y],...]}; `holes` is optional.
/// Points that close a ring or repeat the one before are left out. The prism is validated.
///
/// Errors: BadInput if the text is not JSON of this form, with the path; those of validated(Prism).
Result<FractureInput> readFractureInput(std::string_view json);

/// The method that computes the cells.
enum class FractureMethod {
    Exact,   // voronoiPartition()
    Thesis,  // thesisDiagram() with its errors, for comparison only; ignores holes
};

/// Fractures the prism and returns the result as one line of JSON with a line feed:
///
///     {"cells":[{"seed":i,"area":a,"centroid":[x,y],"pieces":[{"outer":[[x,y],...],"holes":[...]}],
///      "neighbours":[...]},...],
///      "triangles":[[a,b,c],...],
///      "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
///
/// The report begins with the diagnostics of the input. Cells are in seed order, without seeds that have none; outer
/// rings run counter-clockwise, holes clockwise; neighbours share more than kMinSharedEdge of the outline's diameter.
/// Triangles are those of the Delaunay triangulation, counter-clockwise, smallest index first, sorted. Numbers are the
/// shortest that read back as the same double, and points of the outline keep their bits.
///
/// Errors: those of voronoiPartition().
Result<std::string> fractureJson(const FractureInput& input, FractureMethod method, const TaskContext& task = {});

}  // namespace rubble
