#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/pieces/Prism.h"
#include "core/io/fracture/CellList.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

class JsonWriter;

/// Writes a diagnostic of a result of the verb `fracture`: its code, the seeds that it is about, its value as "amount"
/// and its message.
void writeFractureReport(JsonWriter& json, const Diagnostic& report);

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

/// Returns cells, the triangles of their seeds and diagnostics as one line of JSON with a line feed:
///
///     {"cells":[{"seed":i,"area":a,"centroid":[x,y],"pieces":[{"outer":[[x,y],...],"holes":[...]}],
///      "neighbours":[...]},...],
///      "triangles":[[a,b,c],...],
///      "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
///
/// Numbers are the shortest that read back as the same double.
std::string cellsJson(const std::vector<Cell>& cells, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      const std::vector<Diagnostic>& reports);

/// Fractures the prism and returns the result as cellsJson(). The report begins with the diagnostics of the input.
/// Cells are in seed order, without seeds that have none; outer rings run counter-clockwise, holes clockwise;
/// neighbours share more than kMinSharedEdge of the outline's diameter. Triangles are those of the Delaunay
/// triangulation, counter-clockwise, smallest index first, sorted. Points of the outline keep their bits.
///
/// Errors: those of voronoiPartition().
Result<std::string> fractureJson(const FractureInput& input, const TaskContext& task = {});

}  // namespace rubble
