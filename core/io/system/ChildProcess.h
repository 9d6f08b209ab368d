#pragma once

#include "core/base/TaskContext.h"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The environment variables of a child process.
enum class ChildEnvironment { Inherited, Empty };

/// The resource limits of a child process.
struct ChildLimits {
    static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

    std::size_t memory = std::size_t{1} << 30;  // bytes of address space
    double seconds = 10.0;                      // of wall-clock time, and of processor time
    std::size_t output = std::size_t{1} << 29;  // bytes on its standard output
    std::size_t error = 4096;                   // bytes of its standard error that are kept
    std::size_t fileSize = kUnlimited;          // bytes of a file that it writes
    std::size_t descriptors = 1024;             // files that it has open at a time
    ChildEnvironment environment = ChildEnvironment::Inherited;
};

/// How a child process ended.
enum class ChildExit {
    Exited,    // with an exit code
    Crashed,   // by a signal
    TimedOut,  // killed at its limit of time on the clock or of processor time
    TooMuchOutput,
};

struct ChildResult {
    ChildExit exit = ChildExit::Exited;
    int exitCode = 0;
    int signal = 0;      // that ended it, if it crashed
    std::string output;  // standard output
    std::string error;   // the start of standard error
};

/// Runs a program with empty standard input and waits until it ends. Kills it if it exceeds the limits or the task is
/// cancelled. No shell is involved: arguments are passed verbatim. The program inherits no descriptors but its standard
/// streams, and cannot gain privileges.
///
/// Errors: Io if the program cannot be started, with its path and the system's reason; Cancelled.
Result<ChildResult> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                             const ChildLimits& limits, const TaskContext& context);

/// Opens what neither can be read nor written in place of standard streams that are closed, so that no file gets their
/// numbers, and what is printed does not go into it. Call at the start of a program.
void occupyStandardStreams();

/// Returns the first executable file of this name in the folders of PATH, if there is one.
std::optional<std::filesystem::path> findExecutable(const std::string& name);

}  // namespace rubble
