#pragma once

#include "core/base/TaskContext.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The resource limits of a child process.
struct ChildLimits {
    std::size_t memory = std::size_t{1} << 30;  // bytes of address space
    double seconds = 10.0;                      // of wall-clock time, and of processor time
    std::size_t output = std::size_t{1} << 29;  // bytes on its standard output
};

/// How a child process ended.
enum class ChildExit {
    Exited,    // with an exit code
    Crashed,   // by a signal
    TimedOut,  // killed at its time limit
    TooMuchOutput,
};

struct ChildResult {
    ChildExit exit = ChildExit::Exited;
    int exitCode = 0;
    std::string output;  // standard output
    std::string error;   // the first 4 KiB of standard error
};

/// Runs a program with empty standard input and waits until it ends. Kills it if it exceeds the limits or the task is
/// cancelled. No shell is involved: arguments are passed verbatim.
///
/// Errors: Io if the program cannot be started, with its path and the system's reason; Cancelled.
Result<ChildResult> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                             const ChildLimits& limits, const TaskContext& context);

/// Returns the first executable file of this name in the folders of PATH, if there is one.
std::optional<std::filesystem::path> findExecutable(const std::string& name);

}  // namespace rubble
