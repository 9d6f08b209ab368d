#include "app/cli/output/ProjectLoading.h"

#include "app/cli/output/Warnings.h"
#include "core/io/project/ProjectFile.h"

namespace rubble {

Result<Project> openProject(const std::filesystem::path& file, const CliContext& context) {
    std::vector<Diagnostic> notes;
    Result<Project> project = loadProject(file, &notes);
    if (project) printNotes(notes, *project, file.string(), context);
    return project;
}

void printNotes(std::span<const Diagnostic> notes, const Project& project, const std::string& file,
                const CliContext& context) {
    std::vector<AssetWarnings> all;
    for (const Diagnostic& note : notes) all.push_back({findAsset(project, note.place.asset)->name, {note}});
    printWarnings(context, all, file);
}

}  // namespace rubble
