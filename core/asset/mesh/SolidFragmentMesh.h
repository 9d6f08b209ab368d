#pragma once

#include "core/asset/bake/Bake.h"
#include "core/geometry/mesh/Mesh.h"

namespace rubble {

/// The render mesh of a fragment of a closed mesh, less the gap, in its own frame: the triangles of its faces, those of
/// the outside first. UVs are in metres in the face's plane, seen along the axis nearest to its normal; those of
/// the inside are multiplied by the asset's inside scale.
Mesh solidFragmentMesh(const Fragment& fragment, const Asset& asset);

/// The render mesh of a closed mesh about `centre`, with the same UVs.
Mesh solidWholeMesh(const ClosedMesh& mesh, Vec3 centre);

}  // namespace rubble
