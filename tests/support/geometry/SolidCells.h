#pragma once

#include "core/fracture/solid/SolidCut.h"

#include <utility>
#include <vector>

namespace rubble::test {

/// The cells of seeds in a closed mesh; none if it cannot be cut.
inline SolidPartition cellsOf(const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    Result<SolidPartition> partition = cutSolid(mesh, seeds);
    return partition ? std::move(*partition) : SolidPartition{};
}

}  // namespace rubble::test
