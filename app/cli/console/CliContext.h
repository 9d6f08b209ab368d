#pragma once

#include "core/base/TaskContext.h"

#include <filesystem>
#include <iosfwd>

namespace rubble {

/// The exit statuses of rubble-cli.
enum ExitCode : int {
    kExitSuccess = 0,
    kExitError = 1,       // an error, printed to standard error
    kExitUsage = 2,       // arguments that no verb accepts
    kExitFindings = 3,    // the verb ran, and what it looks for was found
    kExitCancelled = 130  // stopped by Ctrl+C, as shells number it
};

/// The streams and the environment of a run of rubble-cli; tests pass their own.
struct CliContext {
    int in;                               // a file descriptor
    std::ostream& out;                    // results
    std::ostream& err;                    // errors and warnings
    std::ostream* terminal = nullptr;     // for progress, which moves the cursor; null: none is shown
    std::filesystem::path programFolder;  // of rubble-cli; rubble-importer is looked for from there
    CancelToken cancel;
};

}  // namespace rubble
