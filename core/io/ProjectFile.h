#pragma once

#include "core/asset/Project.h"
#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// The version of the project files that are written; older ones are read, newer ones refused.
inline constexpr std::uint32_t kProjectVersion = 5;

/// A project as JSON: keys in a fixed order, arrays in id order, a small value a line, every number the shortest that
/// reads back as the same double. The same project gives the same bytes. The project passes verifyProject().
/// docs/formats/project.md tells every field.
std::string projectText(const Project& project);

/// Reads what projectText() wrote, in this version or an older one, bit for bit.
///
/// Errors: BadInput where the text is not such JSON, naming the place ("assets[2].prism.depth: ..."), or where
/// verifyProject() finds a fault; Unsupported where its version is newer; Limit where it is too large.
Result<Project> readProjectText(std::string_view json);

/// Reads a project file. Errors: those of readFile() and of readProjectText(), with the path.
Result<Project> loadProject(const std::filesystem::path& path);

/// Writes a project file, as a whole or not at all.
///
/// Errors: BadInput where verifyProject() finds a fault, Limit where it is too large to be loaded again, with the path;
/// those of writeFileAtomically().
Status saveProject(const std::filesystem::path& path, const Project& project);

}  // namespace rubble
