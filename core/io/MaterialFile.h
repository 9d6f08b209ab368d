#pragma once

#include "core/asset/MaterialPreset.h"
#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A preset of a material as text in JSON; see docs/formats/material.md.
std::string materialPresetText(const MaterialPreset& preset);

/// Reads what materialPresetText() wrote, or what somebody wrote by hand.
///
/// Errors: BadInput where the text is not such JSON or verifyPreset() finds a fault; Unsupported for newer versions.
Result<MaterialPreset> readMaterialPresetText(std::string_view json);

/// The same from a file. Errors: the same, those of readFile(), all with the file's name.
Result<MaterialPreset> loadMaterialPreset(const std::filesystem::path& path);
/// Writes it atomically. Errors: BadInput where verifyPreset() finds a fault; those of writeFileAtomically().
Status saveMaterialPreset(const std::filesystem::path& path, const MaterialPreset& preset);

/// The file in a folder that a preset of this name is saved to: "dark-oak.json" of "Dark oak"; letters beyond ASCII stay, what no file
/// system likes becomes a dash.
std::filesystem::path materialPresetPath(const std::filesystem::path& folder, const std::string& name);

/// A preset, and where it is from.
struct LibraryMaterial {
    MaterialPreset preset;
    std::filesystem::path file;  // empty: it is part of the program
};

/// Presets by name, and what was wrong with those that are left out, a sentence each.
struct MaterialLibrary {
    std::vector<LibraryMaterial> materials;
    std::vector<std::string> faults;
};

/// What is part of the program, and the files `*.json` of a folder of the user's, in the order of their names. One with the name of one
/// of the program's takes its place; of two with one name in the folder, the second is left out. A folder that is not there holds nothing.
MaterialLibrary materialLibrary(const std::filesystem::path& folder = {});

/// The one with a name, whatever the case of its ASCII letters; null where there is none.
const LibraryMaterial* findMaterial(const MaterialLibrary& library, std::string_view name);

/// Materials as JSON: {"materials":[{"file":s, ...},...]}, each as in its file with where that is, null for the program's own.
std::string materialsJson(const std::vector<LibraryMaterial>& materials);

}  // namespace rubble
