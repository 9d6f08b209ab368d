#pragma once

#include "core/asset/library/MaterialPreset.h"
#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Returns a material preset as JSON; see docs/formats/material.md.
std::string materialPresetText(const MaterialPreset& preset);

/// Reads a material preset, written by materialPresetText() or by hand.
///
/// Errors: those of JsonDocument::parse(); BadInput if the text is not of this form or verifyPreset() finds an error;
/// Unsupported for newer versions.
Result<MaterialPreset> readMaterialPresetText(std::string_view json);

/// Loads a material preset from a file.
///
/// Errors, with the path: those of readMaterialPresetText() and readFile().
Result<MaterialPreset> loadMaterialPreset(const std::filesystem::path& path);

/// Saves a material preset to a file atomically.
///
/// Errors: BadInput if verifyPreset() finds an error; those of writeFileAtomically().
Status saveMaterialPreset(const std::filesystem::path& path, const MaterialPreset& preset);

/// Returns the file for a preset of this name in a folder: "dark-oak.json" for "Dark oak". Digits, '_' and letters
/// beyond ASCII stay; a run of other characters becomes a dash.
std::filesystem::path materialPresetPath(const std::filesystem::path& folder, const std::string& name);

/// A material preset and its file.
struct LibraryMaterial {
    MaterialPreset preset;
    std::filesystem::path file;  // empty for a built-in preset
};

/// Material presets sorted by name, and an error message for each file that was skipped.
struct MaterialLibrary {
    std::vector<LibraryMaterial> materials;
    std::vector<std::string> errors;
};

/// Returns the built-in presets and those of the files `*.json` in a user's folder. A user's preset replaces a built-in
/// one of the same name; a second file with the same name is skipped. A missing folder counts as empty.
MaterialLibrary materialLibrary(const std::filesystem::path& folder = {});

/// Returns the preset with a name, ignoring the case of ASCII letters; null if there is none.
const LibraryMaterial* findMaterial(const MaterialLibrary& library, std::string_view name);

/// Returns materials as JSON: {"materials":[{"file":s, ...},...]}, each as in its file; `file` is null for a built-in
/// preset.
std::string materialsJson(const std::vector<LibraryMaterial>& materials);

}  // namespace rubble
