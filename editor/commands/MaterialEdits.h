#pragma once

#include "core/asset/library/MaterialPreset.h"
#include "editor/commands/ProjectEdits.h"

namespace rubble {

/// The parts of a preset to apply to an asset in addition to the material.
struct PresetOptions {
    bool appliesPattern = false;    // replaces the asset's pattern and cut at the impact by the preset's, if it has one
    bool derivesThreshold = false;  // from the tensile strength, if the preset has one; one that is derived stays
};

/// Adds a copy of a preset to the project's materials, with a number if its name is taken. If an equal material exists,
/// returns that and an empty edit.
Addition addMaterial(const Project& project, const MaterialPreset& preset);

/// Gives an asset the material of a preset, added if necessary. A new pattern removes what was set for fragments of the
/// old one: merges, splits, own patterns, thresholds, clusters, and which of them never break.
Edit applyPreset(const Project& project, Id asset, const MaterialPreset& preset, const PresetOptions& options);

/// A preset of a project's material, with the pattern of an asset of this material: the active one if it has it,
/// otherwise the first.
MaterialPreset presetFrom(const Project& project, Id material, Id activeAsset);

}  // namespace rubble
