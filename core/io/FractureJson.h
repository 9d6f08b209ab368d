#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Prism.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A prism and the seeds that cut it.
struct FractureInput {
    Prism prism;
    std::vector<Vec2> seeds;
};

/// Reads {"outline":[[x,y],...], "holes":[[[x,y],...],...], "depth":d, "seeds":[[x,y],...]}; `holes` may be left out. The
/// prism comes out validated.
///
/// Errors: BadInput where the text is not such JSON, naming the place; those of validated(Prism).
Result<FractureInput> readFractureInput(std::string_view json);

/// Which way seeds cut an outline.
enum class FractureMethod {
    Exact,   // ours: voronoiPartition()
    Thesis,  // thesisDiagram(), faults included, for comparison only; holes are ignored
};

/// Cuts the prism and writes what came of it as one line of JSON, ended by a line feed:
///
///     {"cells":[{"seed":i,"area":a,"centroid":[x,y],"pieces":[{"outer":[[x,y],...],"holes":[...]}],"neighbours":[...]},...],
///      "triangles":[[a,b,c],...],
///      "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
///
/// Cells stand in seed order, one for every seed that has one; outer rings run counter-clockwise, holes clockwise;
/// neighbours share more than kLeastSharedEdge of the outline's diameter. Triangles are those of all kept seeds,
/// counter-clockwise, smallest index first, sorted. Numbers are the shortest that read back as the same double, and points
/// that are the outline's own have its very bits.
///
/// Errors: those of voronoiPartition().
Result<std::string> fractureJson(const FractureInput& input, FractureMethod method, const TaskContext& task = {});

}  // namespace rubble
