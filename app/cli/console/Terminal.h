#pragma once

#include "core/base/TaskContext.h"

namespace rubble {

/// Returns whether standard error is a terminal, which can show progress.
bool standardErrorIsTerminal();

/// Makes SIGINT and SIGTERM cancel `token`; the second signal ends the program. Makes a write beyond the file size
/// limit fail instead of ending the program.
void cancelOnSignals(const CancelToken& token);

}  // namespace rubble
