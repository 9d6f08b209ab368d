#pragma once

#include "core/asset/MaterialPreset.h"

namespace rubble {

/// A project with one material, "plaster", and nothing else: what an import is put into.
Project emptyProject();
/// The same with the material of a preset.
Project emptyProject(const MaterialPreset& material);

/// The same with one asset, "wall": 1 x 1 x 0.5 m and 20 scattered seeds, and one instance of it that stands on the
/// ground. Something to break at once.
Project starterProject();
/// The same wall made of the material of a preset, broken in its pattern where it tells one; its threshold follows from the material's
/// strength where that is told.
Project starterProject(const MaterialPreset& material);

}  // namespace rubble
