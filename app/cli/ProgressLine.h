#pragma once

#include "app/cli/Cli.h"

#include <string>

namespace rubble {

/// A line on the terminal that tells how far a task is and is gone when it is done; nothing where `context.err` is no
/// terminal. One thread at a time.
class ProgressLine {
public:
    ProgressLine(const CliContext& context, std::string task) : m_context(context), m_task(std::move(task)) {}
    /// Shows "Exporting  42 %" for 0.42; does nothing where that is what stands there.
    void show(double fraction);
    void clear();

private:
    const CliContext& m_context;
    std::string m_task;
    int m_percent = -1;
};

}  // namespace rubble
