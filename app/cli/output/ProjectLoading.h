#pragma once

#include "app/cli/console/CliContext.h"
#include "core/asset/project/Project.h"
#include "core/base/Diagnostic.h"
#include "core/base/Result.h"

#include <span>
#include <string>

namespace rubble {

/// Loads a project and prints to standard error what was left out of it.
///
/// Errors: those of loadProject().
Result<Project> openProject(const std::filesystem::path& file, const CliContext& context);

/// Prints the notes of readProjectText() on a project, as printWarnings() does.
void printNotes(std::span<const Diagnostic> notes, const Project& project, const std::string& file,
                const CliContext& context);

}  // namespace rubble
