#include "app/cli/console/Terminal.h"

#include <unistd.h>

#include <csignal>

namespace rubble {
namespace {

// A signal handler has no arguments; this is set once, before the handler.
const CancelToken* cancelledBySignal = nullptr;

void cancel(int signal) {
    if (cancelledBySignal->isCancelled()) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    cancelledBySignal->cancel();
}

}  // namespace

bool isTerminal(int descriptor) { return ::isatty(descriptor) == 1; }

void cancelOnSignals(const CancelToken& token) {
    static const CancelToken kept = token;
    cancelledBySignal = &kept;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old {};
        const bool isIgnored = ::sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN;
        if (signal == SIGHUP && isIgnored) continue;  // under nohup
        struct sigaction action {};
        action.sa_handler = cancel;  // without SA_RESTART: a system call that waits is interrupted
        ::sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace rubble
