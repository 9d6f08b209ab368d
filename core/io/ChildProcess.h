#pragma once

#include "core/base/TaskContext.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// What a child process may take.
struct ChildLimits {
    std::size_t memory = std::size_t{1} << 30;  // bytes of address space
    double seconds = 10.0;                      // of the clock, and of its processor
    std::size_t output = std::size_t{1} << 29;  // bytes on its standard output
};

enum class ChildEnd {
    Exited,    // by itself, with its exit code
    Crashed,   // by a signal
    TimedOut,  // it took longer than it may, and was killed
    TooMuchOutput,
};

struct ChildOutcome {
    ChildEnd end = ChildEnd::Exited;
    int exitCode = 0;
    std::string output;
    std::string error;  // the beginning of its standard error
};

/// Runs a program to its end with limits, nothing on its standard input, and kills it when it exceeds them or the caller
/// asks to stop. Not a shell: arguments are handed on as they are.
///
/// Errors: Io where it cannot be started, with the path and the system's reason; Cancelled.
Result<ChildOutcome> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                              const ChildLimits& limits, const TaskContext& context);

/// Where a program of this name lies that the user may run: in the first such folder of PATH; nothing where there is none.
std::optional<std::filesystem::path> programInPath(const std::string& name);

}  // namespace rubble
