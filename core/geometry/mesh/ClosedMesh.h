#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/mesh/MeshVerdict.h"

#include <memory>

namespace rubble {

/// The boundary of a solid, or of several: closed, with two triangles at each edge, counter-clockwise from outside,
/// not crossing itself, as judgeMesh() has it; with what follows from it. Never changes, so copies share it.
struct ClosedMesh {
    TriangleMesh mesh;
    Box3 bounds;
    MassProperties mass;  // at density 1
    ContentHash hash;     // of points and triangles
};

/// What follows from the mesh of a verdict that it can be cut.
std::shared_ptr<const ClosedMesh> closedMesh(MeshVerdict verdict);

/// The same of a mesh that is already closed: nothing may have to be done to it.
///
/// Errors: Degenerate if it cannot be cut as it is, with the sentence of the finding; Cancelled.
Result<std::shared_ptr<const ClosedMesh>> closedMesh(TriangleMesh mesh, const TaskContext& task = {});

/// The mesh scaled by factors above zero about the centre of its box.
std::shared_ptr<const ClosedMesh> scaled(const ClosedMesh& mesh, Vec3 factors);

}  // namespace rubble
