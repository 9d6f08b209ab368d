#pragma once

#include <chrono>
#include <ctime>

namespace rubble::bench {

/// How long something takes, by the clock on the wall.
template <class Work>
double millisecondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The time that the processors take for something: other work on the machine takes none of it.
template <class Work>
double processorMillisecondsOf(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace rubble::bench
