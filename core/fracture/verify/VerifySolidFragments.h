#pragma once

#include "core/fracture/fragments/Fragment.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <optional>
#include <string>

namespace rubble {

/// Why the fragments of a closed mesh are invalid; nothing for valid ones. It checks that the partition covers the mesh
/// but for where its seeds are (see verifySolidPartition()); that masses are those of the fragments and sum up to that
/// of the mesh (relative 1e-9); that the hulls of each fragment are valid polytopes and contain its points; and that
/// contacts are mutual and ascend.
std::optional<std::string> verifySolidFragments(const Fragments& fragments, const TriangleMesh& mesh);

}  // namespace rubble
