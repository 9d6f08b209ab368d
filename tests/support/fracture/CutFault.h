#pragma once

#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/verify/VerifySolidPartition.h"

#include <string>
#include <vector>

namespace rubble::test {

/// Why a mesh cannot be cut, or what is wrong with the result; an empty text if nothing is.
inline std::string cutFault(const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    const Result<SolidPartition> partition = cutSolid(mesh, seeds);
    return partition ? verifySolidPartition(*partition, mesh, seeds).value_or("") : partition.error().message;
}

}  // namespace rubble::test
