#pragma once

#include "core/asset/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// Whom a sentence is about: `Asset 3 "wall"`.
std::string ownerText(const char* kind, Id id, const std::string& name);

/// The first number of a project that is out of range, or the first prism or pattern that cannot be used, as a
/// sentence; the part of verifyProject() that looks at values.
std::optional<std::string> valueFault(const Project& project);

}  // namespace rubble
