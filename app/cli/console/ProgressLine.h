#pragma once

#include "app/cli/console/CliContext.h"

#include <string>

namespace rubble {

/// Shows the progress of a task in a line on the terminal, which is erased at the end. Does nothing without
/// `context.terminal`. Not thread-safe.
class ProgressLine {
public:
    ProgressLine(const CliContext& context, std::string task) : m_context(context), m_task(std::move(task)) {}
    /// Shows "Exporting 42 %" for 0.42, if that is more than before: tasks in stages may report less again.
    void show(double fraction);
    void clear();

private:
    const CliContext& m_context;
    std::string m_task;
    int m_percent = -1;
};

}  // namespace rubble
