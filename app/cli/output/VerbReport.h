#pragma once

#include <memory>
#include <string>

namespace rubble {

/// What a verb that ran found, beside its results.
struct VerbReport {
    /// What the verb looks for and found: faults, differences, failed tests. One or more lines without a line feed at
    /// the end, for standard error. If it is not empty, the program exits with kExitFindings.
    std::string findings;
};

/// Adds a line to the findings.
void addFinding(VerbReport& report, const std::string& line);

}  // namespace rubble
