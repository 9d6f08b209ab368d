#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The first number out of range, or the first prism or pattern that cannot be used, as a sentence; the part of
/// verifyProject() that checks values.
std::optional<std::string> valueFault(const Project& project);

}  // namespace rubble
