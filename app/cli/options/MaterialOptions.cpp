#include "app/cli/options/MaterialOptions.h"

#include "app/cli/options/Command.h"
#include "core/base/MessageText.h"

#include <filesystem>

namespace rubble {

void addMaterialsOption(Command& command, std::string& folder) {
    command.option("--materials", folder, "A folder with your own presets, *.json").typeName("FOLDER");
}

Result<MaterialLibrary> openMaterialLibrary(const std::string& folder) {
    std::error_code ignored;  // an inaccessible folder counts as missing
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
        return Error{ErrorCode::NotFound, "There is no folder " + quotedPath(folder) + "."};
    }
    return materialLibrary(folder);
}

Result<LibraryMaterial> requireMaterial(const MaterialLibrary& library, const std::string& name) {
    if (const LibraryMaterial* found = findMaterial(library, name)) return *found;
    std::vector<std::string> names;
    for (const LibraryMaterial& material : library.materials) names.push_back(material.preset.name);
    std::string message =
        "There is no material " + quotedName(name) + "; the materials are " + quotedNames(names) + ".";
    for (const std::string& error : library.errors) message += "\n" + error;
    return Error{ErrorCode::NotFound, message};
}

}  // namespace rubble
