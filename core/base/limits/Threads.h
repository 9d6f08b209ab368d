#pragma once

#include <functional>
#include <thread>

namespace rubble {

/// Starts a thread, which its destructor joins. Where the system allows no more, it is not joinable, and `work` is not
/// called.
std::jthread startedThread(std::function<void()> work);

/// Whether the system allows `count` more threads now: for libraries that end the process, or wait forever, where it
/// does not.
bool canStartThreads(int count);

/// Gives the calling thread, and those that it starts from now on, a smaller part of a processor than others that want
/// it: for long work beside which a program should respond.
void lowerThreadPriority();

}  // namespace rubble
