#pragma once

#include "core/io/MaterialFile.h"

#include <string>

namespace CLI {
class App;
}

namespace rubble {

/// Adds --materials, the folder with the user's own presets.
void addMaterialsOption(CLI::App& command, std::string& folder);

/// The program's presets and those of a folder; empty: the program's alone.
///
/// Errors: NotFound where there is no such folder.
Result<MaterialLibrary> chosenLibrary(const std::string& folder);

/// The preset with a name, whatever the case of its letters.
///
/// Errors: NotFound, with the names there are and what was wrong with files that are left out.
Result<LibraryMaterial> chosenMaterial(const MaterialLibrary& library, const std::string& name);

}  // namespace rubble
