#include "tests/attack/monkey/CrashTrace.h"

#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace rubble::attack {
namespace {

constexpr int kMaxFrames = 64;

void printTrace(int signal) {
    std::array<void*, kMaxFrames> frames{};
    ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kMaxFrames), STDERR_FILENO);
    ::raise(signal);  // with its default action, which SA_RESETHAND restored
}

}  // namespace

void traceCrashes() {
    std::array<void*, 1> frame{};
    ::backtrace(frame.data(), 1);  // loads what the handler must not allocate
    struct sigaction action {};
    action.sa_handler = printTrace;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(signal, &action, nullptr);
}

}  // namespace rubble::attack
