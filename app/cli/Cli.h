#pragma once

#include "app/cli/console/CliContext.h"

#include <string>
#include <vector>

namespace rubble {

/// Runs rubble-cli with its arguments (without the program's name) and returns its ExitCode.
int runCli(const std::vector<std::string>& arguments, const CliContext& context);

/// An option, or a positional argument, whose value is a file that is written: "draw", "--out".
struct WrittenOption {
    std::string verb;
    std::string option;
};
/// All of them, in the order of verbs and options.
std::vector<WrittenOption> writtenOptions();

}  // namespace rubble
