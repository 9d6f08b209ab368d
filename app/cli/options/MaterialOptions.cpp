#include "app/cli/options/MaterialOptions.h"

#include "app/cli/options/Command.h"

#include <filesystem>

namespace rubble {

void addMaterialsOption(Command& command, std::string& folder) {
    command.option("--materials", folder, "A folder with your own presets, *.json").typeName("FOLDER");
}

Result<MaterialLibrary> openMaterialLibrary(const std::string& folder) {
    std::error_code ignored;  // an inaccessible folder counts as missing
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
        return Error{ErrorCode::NotFound, "There is no folder \"" + folder + "\"."};
    }
    return materialLibrary(folder);
}

Result<LibraryMaterial> requireMaterial(const MaterialLibrary& library, const std::string& name) {
    if (const LibraryMaterial* found = findMaterial(library, name)) return *found;
    std::string names;
    for (const LibraryMaterial& material : library.materials) {
        names += (names.empty() ? "\"" : ", \"") + material.preset.name + '"';
    }
    std::string message = "There is no material \"" + name + "\"; the materials are " + names + ".";
    for (const std::string& error : library.errors) message += "\n" + error;
    return Error{ErrorCode::NotFound, message};
}

}  // namespace rubble
