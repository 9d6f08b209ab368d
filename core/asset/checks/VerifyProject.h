#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The first fault that keeps a project from being used, as a sentence, or nothing: ids that are not unique, ascending
/// and below nextId; names that are empty or taken; references to missing elements; numbers out of range; prisms and
/// patterns that cannot be fractured.
std::optional<std::string> verifyProject(const Project& project);
/// The part of verifyProject() that checks ids, names and references.
std::optional<std::string> structureFault(const Project& project);

}  // namespace rubble
