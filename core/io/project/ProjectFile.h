#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/io/project/MeshFolder.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The newest version of project files. Older ones are read, newer ones rejected. Projects without meshes are written
/// as version 5, which older programs read.
inline constexpr std::uint32_t kProjectVersion = 6;

/// Returns a project as JSON: keys in a fixed order, arrays in id order, small values on one line each, every number
/// the shortest that reads back as the same double. Equal projects give equal bytes. The project must pass
/// verifyProject(). Of closed meshes it has only the hashes: see saveMeshes(). All fields are described in
/// docs/formats/project.md.
std::string projectText(const Project& project);

/// Reads a project written by projectText() in this version or an older one, bit for bit. Points of outlines and holes
/// that close a ring or repeat the one before, as other programs write them, are left out; `notes`, if given, gets a
/// RepeatedPoint with their number for each asset that has some. `meshes` gives the closed meshes.
///
/// Errors: BadInput if the text is not JSON of this form, with the path ("assets[2].prism.depth: ..."), or if
/// verifyProject() finds an error; Unsupported if its version is newer; Limit if it is too large; those of
/// readMeshes().
Result<Project> readProjectText(std::string_view json, std::vector<Diagnostic>* notes = nullptr,
                                const MeshSource& meshes = {});
/// The same for the text of a file, whose path the errors name, with the meshes beside it. An interrupted save is
/// reported as one.
Result<Project> readProjectText(std::string_view json, const std::filesystem::path& path,
                                std::vector<Diagnostic>* notes = nullptr);

/// Reads some elements of a project, as projectText() wrote them, without verifying it: they may refer to others.
///
/// Errors: those of readProjectText() about the form of the text, and those of readMeshes().
Result<Project> readProjectPart(std::string_view json, const MeshSource& meshes = {});

/// Loads a project file. `notes` as for readProjectText().
///
/// Errors, with the path: those of readFile() and readProjectText().
Result<Project> loadProject(const std::filesystem::path& path, std::vector<Diagnostic>* notes = nullptr);

/// A project of which some values may be out of range.
struct RecoveredProject {
    Project project;
    std::vector<std::string> faults;  // valueFaults()
};
/// Loads a project file, such as a backup, also with values out of range, from which the project can be mended.
///
/// Errors, with the path: those of loadProject(), except for such values; BadInput for outlines that validated()
/// rejects, as they cannot be shown.
///
/// With what was edited since, where there is a file `journal`, see replayed(); edits that do not fit are left out,
/// which a fault reports.
Result<RecoveredProject> recoverProject(const std::filesystem::path& path, const std::filesystem::path& journal = {});

/// Saves a project file atomically, and removes what killed programs left beside it. Before, the meshes that are not
/// there yet are saved beside it.
///
/// Errors, with the path: BadInput if verifyProject() finds an error; Limit if it is too large to be loaded again;
/// those of saveMeshes() and writeFileAtomically().
Status saveProject(const std::filesystem::path& path, const Project& project);

}  // namespace rubble
