#pragma once

#include "core/io/project/MaterialPresetFile.h"

#include <string>

namespace rubble {

class Command;

/// Adds --materials, the folder with the user's presets.
void addMaterialsOption(Command& command, std::string& folder);

/// Returns the built-in presets and those of a folder, if one is given.
///
/// Errors: NotFound if there is no such folder.
Result<MaterialLibrary> openMaterialLibrary(const std::string& folder);

/// Returns the preset with a name, ignoring case.
///
/// Errors: NotFound, with the names of all presets and the errors of skipped files.
Result<LibraryMaterial> requireMaterial(const MaterialLibrary& library, const std::string& name);

}  // namespace rubble
