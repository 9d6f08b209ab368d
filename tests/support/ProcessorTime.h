#pragma once

#include <sys/resource.h>

namespace rubble::test {

/// The processor time of the calling thread outside of the kernel, ms: unlike the time on the clock, it depends neither
/// on other programs nor on what a fresh page of memory costs, which differs a hundredfold between machines.
inline double processorTime() {
    rusage used{};
    getrusage(RUSAGE_THREAD, &used);
    return 1e3 * static_cast<double>(used.ru_utime.tv_sec) + 1e-3 * static_cast<double>(used.ru_utime.tv_usec);
}

}  // namespace rubble::test
