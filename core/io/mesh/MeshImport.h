#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/SourceScene.h"
#include "core/io/system/ChildProcess.h"

#include <filesystem>

namespace rubble {

/// Returns the absolute path of rubble-importer for a program in `programFolder`: in the same folder in a build tree,
/// in ../libexec/rubble in an installation. Where the folder is not known, the path in /usr.
std::filesystem::path importerPath(const std::filesystem::path& programFolder);

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file in a child process, rubble-importer, limited to 2 GiB and 30 s: a file
/// on which the reader crashes, hangs or runs out of memory is reported as an error. docs/security.md says what the
/// child may do. `importer` is an absolute path.
///
/// Errors, with the file's name: NotFound or Io if it cannot be opened; Unsupported, Degenerate or Limit if the reader
/// rejects it, crashes or exceeds its limits; Io if the importer cannot be started or its path is not absolute;
/// Cancelled.
Result<SourceScene> importMesh(const std::filesystem::path& file, const std::filesystem::path& importer,
                               const TaskContext& context);

/// The limits that importMesh() sets to the importer.
ChildLimits importerLimits();

/// Returns the mesh that the importer wrote, as importMesh() does once it has ended. `file`: which it read.
///
/// Errors: those of importMesh() that are about what the importer did.
Result<SourceScene> importedMesh(const ChildResult& outcome, const std::filesystem::path& file);

}  // namespace rubble
