#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/mesh/MeshVerdict.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A closed mesh and the seeds of its fracture pattern.
struct SolidFractureInput {
    TriangleMesh mesh;                   // that of a MeshVerdict
    std::vector<std::uint32_t> sources;  // each triangle's index in the input, ascending
    std::vector<Vec3> seeds;
    std::vector<MeshFinding> notes;  // what was done to the mesh, and what holds of it
};

/// Whether a text is of the form of readSolidFractureInput(): an object with a mesh.
bool hasMesh(std::string_view json);

/// Reads {"mesh":{"points":[[x,y,z],...],"triangles":[[a,b,c],...]}, "seeds":[[x,y,z],...]}, in metres.
///
/// Errors: BadInput if the text is not JSON of this form, with the path, or has no seed; Degenerate if the mesh cannot
/// be cut, as judgeMesh() says; Cancelled.
Result<SolidFractureInput> readSolidFractureInput(std::string_view json, const TaskContext& task = {});

/// Cuts the mesh and returns its fragments as one line of JSON with a line feed:
///
///     {"points":[[x,y,z],...],
///      "faces":[{"fragment":f,"behind":g,"triangles":[[a,b,c],...]},
///               {"fragment":f,"source":t,"triangles":[[a,b,c],...]},...],
///      "fragments":[{"seed":i,"volume":v,"centroid":[x,y,z],"faces":[...],"neighbours":[...]},...],
///      "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
///
/// Each face is there once: its triangles are counter-clockwise seen from outside `fragment`, and clockwise seen from
/// outside the one `behind` it; faces of the outside have the triangle of the input that they are part of. The first
/// points are those of the mesh, with their bits; of a clean mesh, in their order. Notes of the mesh are in the report
/// by their names, with a message.
///
/// Errors: those of cutSolid().
Result<std::string> solidFractureJson(const SolidFractureInput& input, const TaskContext& task = {});

}  // namespace rubble
