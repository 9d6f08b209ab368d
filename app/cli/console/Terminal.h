#pragma once

#include "core/base/TaskContext.h"

namespace rubble {

/// Returns whether a file descriptor is a terminal.
bool isTerminal(int descriptor);

/// Makes SIGINT, SIGTERM and SIGHUP cancel `token`; the second signal ends the program. Makes a write beyond the file
/// size limit fail instead of ending the program.
void cancelOnSignals(const CancelToken& token);

}  // namespace rubble
