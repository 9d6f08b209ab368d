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

bool standardErrorIsTerminal() { return isatty(STDERR_FILENO) == 1; }

void cancelOnSignals(const CancelToken& token) {
    static const CancelToken kept = token;
    cancelledBySignal = &kept;
    std::signal(SIGINT, cancel);
    std::signal(SIGTERM, cancel);
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace rubble
