#pragma once

namespace rubble::attack {

/// From now on a crash of this process prints its backtrace to standard error: addresses for addr2line.
void traceCrashes();

}  // namespace rubble::attack
