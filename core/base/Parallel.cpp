#include "core/base/Parallel.h"

#include "core/base/limits/Spinning.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

namespace rubble {
namespace {

template <class IsDone>
void spinUntil(const IsDone& isDone) {
    for (int spin = 0; spin < kSpins && !isDone(); ++spin) pauseBetweenLooks();
}

/// A loop whose indices several threads take one by one.
class Loop {
public:
    Loop(std::size_t count, int helpers, const std::function<void(std::size_t)>& work)
        : m_work(work), m_count(count), m_helpers(helpers) {}

    bool wantsHelper() const { return m_joined < m_helpers && m_next.load(std::memory_order_relaxed) < m_count; }
    void join() {
        ++m_joined;
        m_inside.fetch_add(1, std::memory_order_relaxed);
    }
    void leave() { m_inside.fetch_sub(1, std::memory_order_release); }
    bool isLeft() const { return m_inside.load(std::memory_order_acquire) == 0; }

    /// Works on indices until none are left. After an exception the others are left out.
    void run() noexcept {
        while (true) {
            const std::size_t index = m_next.fetch_add(1, std::memory_order_relaxed);
            if (index >= m_count) return;
            try {
                m_work(index);
            } catch (...) {
                if (!m_hasFailed.exchange(true)) m_failure = std::current_exception();
                m_next.store(m_count, std::memory_order_relaxed);
            }
        }
    }
    void throwKept() {
        if (m_failure) std::rethrow_exception(std::exchange(m_failure, nullptr));
    }

private:
    const std::function<void(std::size_t)>& m_work;
    const std::size_t m_count;
    const int m_helpers;                 // at most
    int m_joined = 0;                    // that ever came; guarded by the pool
    std::atomic<int> m_inside{0};        // helpers
    std::atomic<std::size_t> m_next{0};  // may pass m_count
    std::atomic<bool> m_hasFailed{false};
    std::exception_ptr m_failure;  // written by the thread that sets m_hasFailed
};

/// Threads that help with loops. The thread that starts a loop works on it, too, so that each loop ends without
/// helpers: where the system allows no thread, within loops of loops, and in a forked process, which has none of them.
class Helpers {
public:
    void run(Loop& loop, int helpers) {
        {
            const std::lock_guard lock(m_guard);
            startThreads(helpers);
            if (m_threads > 0) m_loops.push_back(&loop);
            m_open.store(m_loops.size(), std::memory_order_relaxed);
        }
        m_wake.notify_all();
        loop.run();
        {
            const std::lock_guard lock(m_guard);
            std::erase(m_loops, &loop);
            m_open.store(m_loops.size(), std::memory_order_relaxed);
        }
        spinUntil([&] { return loop.isLeft(); });
        std::unique_lock lock(m_guard);
        m_left.wait(lock, [&] { return loop.isLeft(); });
    }

private:
    /// Starts threads until there are `count`, or as many as the system allows.
    void startThreads(int count) {
        m_loops.reserve(m_loops.size() + 1);
        try {
            for (; m_threads < count; ++m_threads) std::thread([this] { help(); }).detach();
        } catch (const std::system_error&) {
        } catch (const std::bad_alloc&) {
        }
    }

    void help() {
        std::unique_lock lock(m_guard);
        while (true) {
            const auto wanting = std::ranges::find_if(m_loops, [](const Loop* loop) { return loop->wantsHelper(); });
            if (wanting == m_loops.end()) {
                m_wake.wait(lock);
                continue;
            }
            Loop& loop = **wanting;
            loop.join();
            lock.unlock();
            loop.run();
            lock.lock();
            loop.leave();
            m_left.notify_all();
            lock.unlock();
            spinUntil([this] { return m_open.load(std::memory_order_relaxed) > 0; });
            lock.lock();
        }
    }

    std::mutex m_guard;
    std::condition_variable m_wake;
    std::condition_variable m_left;
    std::vector<Loop*> m_loops;
    std::atomic<std::size_t> m_open{0};  // the size of m_loops
    int m_threads = 0;
};

/// Never destroyed: its threads wait until the process ends.
Helpers& helpers() {
    static auto& shared = *new Helpers;
    return shared;
}

}  // namespace

int availableProcessors() {
#ifdef __linux__
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work) {
    const auto most = static_cast<int>(std::min<std::size_t>(count, static_cast<std::size_t>(threads)));
    const int wanted = std::min(most, availableProcessors()) - 1;
    Loop loop(count, wanted, work);
    if (wanted > 0) {
        helpers().run(loop, wanted);
    } else {
        loop.run();
    }
    loop.throwKept();
}

}  // namespace rubble
