#pragma once

#include "core/base/TaskContext.h"

namespace rubble {

/// True where standard error is a terminal, on which progress may be drawn.
bool standardErrorIsTerminal();

/// From now on Ctrl+C and a request to terminate cancel `token`; the second one ends the program at once. A file that
/// grows beyond the allowed size becomes a fault of the write, not the end of the program.
void cancelOnSignals(const CancelToken& token);

}  // namespace rubble
