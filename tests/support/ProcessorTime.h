#pragma once

#include <time.h>

namespace rubble::test {

/// The processor time of the calling thread, ms: unlike the time on the clock, it does not depend on other programs.
inline double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace rubble::test
