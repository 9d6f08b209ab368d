#pragma once

#include "core/base/TaskContext.h"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace rubble {

/// What rubble-cli ends with.
enum ExitCode : int {
    kExitSuccess = 0,
    kExitBadInput = 1,    // a fault, told in one sentence on err
    kExitUsage = 2,       // arguments that no verb takes
    kExitCancelled = 130  // stopped by Ctrl+C, as shells count it
};

/// All that a run touches of the outside world, beside files.
struct CliContext {
    std::istream& in;
    std::ostream& out;  // results
    std::ostream& err;  // one sentence a fault; progress
    bool errIsTerminal = false;
    std::filesystem::path programFolder;  // where rubble-cli lies: rubble-importer is looked for from there
    CancelToken cancel;
};

/// Runs rubble-cli with its arguments (without the program's name) and gives its ExitCode.
int runCli(const std::vector<std::string>& arguments, const CliContext& context);

}  // namespace rubble
