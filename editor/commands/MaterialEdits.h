#pragma once

#include "core/asset/MaterialPreset.h"
#include "editor/commands/ProjectEdits.h"

namespace rubble {

/// What an asset takes of a preset besides its figures.
struct PresetUse {
    bool takesPattern = false;      // that it usually breaks in, in place of the asset's own
    bool derivesThreshold = false;  // from the strength, where that is told
};

/// Adds a copy of a preset to a project's materials; the name is numbered where it is taken. One that is there with the same name and
/// values is taken as it is: the edit is empty then.
Addition addMaterial(const Project& project, const MaterialPreset& preset);

/// Makes an asset of a preset: adds the material unless it is there, and takes what is told. With another pattern, what was said of
/// fragments of the old one (merged, split, broken in their own way) is dropped.
Edit makeOf(const Project& project, Id asset, const MaterialPreset& preset, const PresetUse& use);

/// A preset of a project's material, with the pattern of an asset that is made of it where there is one: that at hand, or the first.
MaterialPreset presetFrom(const Project& project, Id material, Id assetAtHand);

}  // namespace rubble
