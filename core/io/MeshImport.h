#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/SourceScene.h"

#include <filesystem>

namespace rubble {

/// Where rubble-importer lies, for a program in a folder: beside it, as built; else in ../libexec/rubble, as installed,
/// for no one calls it by hand.
std::filesystem::path importerBeside(const std::filesystem::path& programFolder);

/// Reads an OBJ, glTF, GLB, FBX, STL or PLY file in a process of its own (rubble-importer), which may take 1 GiB and
/// 10 s: a file that makes the reader crash, hang or eat memory costs a sentence.
///
/// Errors, each with the file's name: NotFound or Io where it cannot be opened; Unsupported, Degenerate or Limit where it
/// is refused, crashes the reader or takes too much; Io where the importer cannot be started; Cancelled.
Result<SourceScene> importMesh(const std::filesystem::path& file, const std::filesystem::path& importer,
                               const TaskContext& context);

}  // namespace rubble
