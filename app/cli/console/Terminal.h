#pragma once

#include "core/base/TaskContext.h"

namespace rubble {

/// Returns whether standard error is a terminal, which can show progress.
bool standardErrorIsTerminal();

/// Makes SIGINT and SIGTERM cancel `token`; the second signal ends the program. Makes exceeding the file size limit an
/// error of the write instead of the end of the program.
void cancelOnSignals(const CancelToken& token);

}  // namespace rubble
