#pragma once

#include "core/base/Result.h"

#include <span>
#include <string>

namespace rubble {

/// Returns a rule for Make and Ninja: the targets depend on the prerequisites. Spaces, '#', ':' and '$' in paths are
/// escaped; Ninja reads no '%' otherwise than as itself, so it stays.
///
/// Errors: BadInput if a path has a line feed or a tab, which Make cannot express.
/// Source: the dependencies that GCC writes (libcpp/mkdeps.c) and that Ninja reads (depfile_parser.in.cc).
Result<std::string> depfileText(std::span<const std::string> targets, std::span<const std::string> prerequisites);

}  // namespace rubble
