#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Result.h"

#include <filesystem>
#include <functional>

namespace rubble {

// The closed meshes of a project lie in files of their own in a folder beside it, named by their hashes. A file is
// written once: another mesh has another name. Saving removes none, since copies of the project may need them.

/// Returns the folder of a project's meshes: "house.rubble.meshes" for "house.rubble", beside what a symbolic link
/// leads to.
std::filesystem::path meshFolderOf(const std::filesystem::path& project);

/// The path of the file of a mesh: its hash, and ".mesh".
std::filesystem::path meshPath(const std::filesystem::path& folder, const ContentHash& hash);

/// Whether a path is that of a file in the folder of a project's meshes, by the name of the folder.
bool isInMeshFolder(const std::filesystem::path& path);

/// Writes the meshes of a project's assets into a folder, each atomically, but those that are there: a file that is cut
/// off, or another one, is replaced. Creates the folder if there is something to write.
///
/// Errors, with the asset or the path: Degenerate for a mesh that closedMesh() would refuse, since it could not be read
/// again; those of checkMeshSize(), CreatedDirectories::create() and writeFileAtomically().
Status saveMeshes(const Project& project, const std::filesystem::path& folder);

/// Returns the mesh of a hash for a project that is read. Empty: there are none, as for a text without a file.
using MeshSource = std::function<Result<std::shared_ptr<const ClosedMesh>>(const ContentHash& hash)>;

/// The meshes in a folder, each read once. Links are refused: they may lead to any file.
///
/// Errors of the source, with the path and what to do: NotFound; those of readFile() and readMeshBytes().
MeshSource meshesIn(const std::filesystem::path& folder);

}  // namespace rubble
