#pragma once

#include "core/asset/library/MaterialPreset.h"

namespace rubble {

/// A project with nothing but one material, the "plaster" of the library: the target of an import.
Project emptyProject();
/// A project with nothing but the material of a preset.
Project emptyProject(const MaterialPreset& material);

/// An emptyProject() with one asset, "wall", of 1 x 1 x 0.5 m, 20 scattered seeds and a derived threshold, and one
/// instance of it on the ground.
Project starterProject();
/// The same wall of the material of a preset, with its pattern if it has one, and a derived threshold if its strength
/// is known.
Project starterProject(const MaterialPreset& material);

}  // namespace rubble
