#pragma once

#include "app/cli/console/CliContext.h"

#include <string>
#include <vector>

namespace rubble {

/// Runs rubble-cli with its arguments (without the program's name) and returns its ExitCode.
int runCli(const std::vector<std::string>& arguments, const CliContext& context);

}  // namespace rubble
