#include "app/cli/MaterialOptions.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace rubble {

void addMaterialsOption(CLI::App& command, std::string& folder) {
    command.add_option("--materials", folder, "A folder with presets of your own, *.json, beside the program's")
        ->type_name("FOLDER");
}

Result<MaterialLibrary> chosenLibrary(const std::string& folder) {
    std::error_code ignored;  // what cannot be looked at is no folder to read from
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
        return Error{ErrorCode::NotFound, "There is no folder \"" + folder + "\"."};
    }
    return materialLibrary(folder);
}

Result<LibraryMaterial> chosenMaterial(const MaterialLibrary& library, const std::string& name) {
    if (const LibraryMaterial* found = findMaterial(library, name)) return *found;
    std::string names;
    for (const LibraryMaterial& material : library.materials) {
        names += (names.empty() ? "\"" : ", \"") + material.preset.name + '"';
    }
    std::string sentence = "There is no material \"" + name + "\"; there are " + names + ".";
    for (const std::string& fault : library.faults) sentence += "\n" + fault;
    return Error{ErrorCode::NotFound, sentence};
}

}  // namespace rubble
