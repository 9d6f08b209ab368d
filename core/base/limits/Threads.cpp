#include "core/base/limits/Threads.h"

#include <sys/resource.h>

#include <atomic>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace rubble {

std::jthread startedThread(std::function<void()> work) {
    try {
        return std::jthread(std::move(work));
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {  // of its stack
    }
    return {};
}

void lowerThreadPriority() {
    constexpr int kNiceness = 5;              // a third of the time of others
    setpriority(PRIO_PROCESS, 0, kNiceness);  // on Linux, of the calling thread
}

bool canStartThreads(int count) {
    std::atomic<bool> isDecided{false};
    std::vector<std::jthread> threads;
    threads.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        std::jthread thread = startedThread([&] { isDecided.wait(false); });
        if (!thread.joinable()) break;
        threads.push_back(std::move(thread));
    }
    isDecided = true;
    isDecided.notify_all();
    return static_cast<int>(threads.size()) == count;
}

}  // namespace rubble
