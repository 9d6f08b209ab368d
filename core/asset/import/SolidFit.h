#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/ClosedMesh.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A closed mesh in the frame of an asset: the origin is the centre of its bounding box, the axes are the world's.
struct SolidFit {
    std::shared_ptr<const ClosedMesh> mesh;
    Vec3 position{0.0, 0.0, 0.0};  // m: of the frame in the world
    std::uint32_t parts = 0;       // separate solids
    std::uint32_t cavities = 0;
    std::string whyNoPrism;  // a sentence; empty if no prism was wanted
};

/// Where a mesh cannot be cut as a solid.
struct MeshProblem {
    std::string message;                         // one sentence with count and place
    Vec3 place{0.0, 0.0, 0.0};                   // m, in the world: of the first fault
    std::vector<std::array<Vec3, 3>> triangles;  // m, in the world; at most kMaxMarked
    std::vector<std::array<Vec3, 2>> edges;      // the same
    bool operator==(const MeshProblem&) const = default;
};

/// A mesh as a solid, or why it is none.
struct SolidTrial {
    std::optional<SolidFit> solid;
    std::optional<MeshProblem> problem;  // if there is no solid
    std::vector<std::string> notes;      // sentences: what was joined, turned or left out
};

/// Makes an asset's solid of a mesh in the world, m, if judgeMesh() finds that it can be cut. Points move by the centre
/// of the box around the triangles only. The result does not depend on the number of threads.
///
/// Errors: Cancelled.
Result<SolidTrial> fittedSolid(const TriangleMesh& mesh, const TaskContext& context);

}  // namespace rubble
