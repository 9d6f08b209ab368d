#pragma once

#include "core/asset/import/ImportedSolid.h"

namespace rubble {

/// Whether an imported asset has the prism and the surface of a solid, but for differences up to `tolerance`, m.
bool isEqual(const Asset& asset, const ImportedSolid& solid, double tolerance);

}  // namespace rubble
