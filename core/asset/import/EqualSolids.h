#pragma once

#include "core/asset/import/ImportedSolid.h"

namespace rubble {

/// Whether an imported asset has the prism, the surface and the texture of a solid, but for differences up to
/// `tolerance`, m; or its closed mesh, with the same triangles in the same order and not rotated.
bool isEqual(const Asset& asset, const ImportedSolid& solid, double tolerance);

}  // namespace rubble
