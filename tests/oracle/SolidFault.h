#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <optional>
#include <span>
#include <string>

namespace rubble::oracle {

/// Cuts a mesh and compares the fragments with exactSolidCells() and verifySolidPartition(). Returns the first fault,
/// or nothing.
///
/// Mesh and seeds have to be on the lattice of the cut, so that nothing is rounded before signs decide: then the
/// numbers of parts and shells, Euler numbers and neighbours agree exactly, volumes and areas to 1e-12 of the mesh's
/// box.
std::optional<std::string> solidFault(const TriangleMesh& mesh, std::span<const Vec3> seeds);

/// The mesh with its points rounded to multiples of 2⁻¹², which are on the lattice of the cut.
TriangleMesh onCoarseLattice(TriangleMesh mesh);

}  // namespace rubble::oracle
