#pragma once

#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/solid/SolidCut.h"

namespace rubble {

/// Cuts a closed mesh into the cells of seeds, see cutSolid(). If the pattern has grain layers, the metric is
/// anisotropic: mesh and seeds are mapped, cut, and mapped back; the corners of the mesh keep their bits.
///
/// Errors: those of cutSolid().
Result<SolidPartition> cutWithPattern(const Pattern& pattern, const TriangleMesh& mesh, std::span<const Vec3> seeds,
                                      const TaskContext& task = {});

}  // namespace rubble
