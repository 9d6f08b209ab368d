#include "core/base/ThreadPool.h"

#include "core/base/limits/Spinning.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

namespace rubble {
namespace {

/// One or two microseconds, within which a spinning worker notices new work.
constexpr int kWakeSpins = 64;
/// More than one, so that a late worker leaves less to the others.
constexpr std::size_t kChunksPerThread = 4;

struct Remaining {
    std::uint32_t stage;
    std::uint32_t first;
    std::uint32_t end;
};
constexpr unsigned kChunkBits = 16;
constexpr std::uint64_t kChunkMask = (1u << kChunkBits) - 1;

std::uint64_t packed(const Remaining& remaining) {
    return std::uint64_t{remaining.stage} << (2 * kChunkBits) | std::uint64_t{remaining.first} << kChunkBits |
           remaining.end;
}
Remaining unpacked(std::uint64_t bits) {
    return {static_cast<std::uint32_t>(bits >> (2 * kChunkBits)),
            static_cast<std::uint32_t>(bits >> kChunkBits & kChunkMask), static_cast<std::uint32_t>(bits & kChunkMask)};
}

}  // namespace

ThreadPool::ThreadPool(int size)
    : m_progress(static_cast<std::size_t>(std::max(size, 1))), m_spins(size <= availableProcessors() ? kSpins : 0) {
    m_threads.reserve(m_progress.size() - 1);
    try {
        while (m_threads.size() + 1 < m_progress.size()) m_threads.emplace_back([this] { runWorker(); });
    } catch (const std::system_error&) {  // the system allows no more threads
    } catch (const std::bad_alloc&) {
    }
}

ThreadPool::~ThreadPool() {
    m_isStopping.store(true, std::memory_order_relaxed);
    m_stage.fetch_add(1, std::memory_order_release);
    m_stage.notify_all();
    for (std::thread& thread : m_threads) thread.join();
}

std::size_t ThreadPool::chunkCount(std::size_t count, std::size_t least) const {
    const std::size_t workers = m_threads.size() + 1;
    if (workers == 1 || count < 2 * least) return 1;
    return std::min(count / least, kChunksPerThread * workers);
}

void ThreadPool::runWorker() {
    std::uint32_t seen = 0;
    m_awake.fetch_add(1, std::memory_order_relaxed);
    while (true) {
        for (int spin = 0; spin < m_spins && m_stage.load(std::memory_order_acquire) == seen; ++spin)
            pauseBetweenLooks();
        if (m_stage.load(std::memory_order_acquire) == seen) {
            m_awake.fetch_sub(1, std::memory_order_relaxed);
            m_stage.wait(seen, std::memory_order_acquire);
            m_awake.fetch_add(1, std::memory_order_relaxed);
        }
        seen = m_stage.load(std::memory_order_acquire);
        if (m_isStopping.load(std::memory_order_relaxed)) return;
        takeChunks(seen, false);
    }
}

void ThreadPool::keepException() noexcept {
    if (!m_hasFailed.exchange(true)) m_failure = std::current_exception();
}

void ThreadPool::throwKept() {
    if (!m_hasFailed.load()) return;
    m_hasFailed.store(false);
    std::rethrow_exception(std::exchange(m_failure, nullptr));
}

void ThreadPool::takeChunks(std::uint32_t stage, bool isCaller) {
    std::uint64_t bits = m_remaining.load(std::memory_order_acquire);
    while (true) {
        Remaining remaining = unpacked(bits);
        if (remaining.stage != stage || remaining.first == remaining.end) return;
        const std::uint32_t chunk = isCaller ? remaining.first++ : --remaining.end;
        if (!m_remaining.compare_exchange_weak(bits, packed(remaining), std::memory_order_acq_rel)) continue;
        try {
            (*m_work)(chunk);
        } catch (...) {
            keepException();
        }
        m_done.fetch_add(1, std::memory_order_release);
        bits = m_remaining.load(std::memory_order_acquire);
    }
}

std::uint32_t ThreadPool::open(const std::function<void(std::size_t)>& work, std::size_t first, std::size_t chunks) {
    const std::uint32_t stage = m_stage.load(std::memory_order_relaxed) + 1;
    m_work = &work;
    m_done.store(0, std::memory_order_relaxed);
    m_remaining.store(packed({stage, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(chunks)}),
                      std::memory_order_release);
    m_stage.store(stage, std::memory_order_release);
    m_stage.notify_all();
    return stage;
}

template <class IsDone>
void ThreadPool::waitUntil(const IsDone& isDone) const {
    for (int spin = 0; !isDone(); ++spin) {
        if (spin < m_spins) {
            pauseBetweenLooks();
        } else {
            std::this_thread::yield();
        }
    }
}

void ThreadPool::runChunksOnThreads(std::size_t chunks, const std::function<void(std::size_t)>& work) {
    takeChunks(open(work, 0, chunks), true);
    waitUntil([&] { return m_done.load(std::memory_order_acquire) == chunks; });
    throwKept();
}

void ThreadPool::waitForAwakeWorkers() const {
    const auto isAnyRemaining = [&] {
        const Remaining remaining = unpacked(m_remaining.load(std::memory_order_acquire));
        return remaining.first < remaining.end;
    };
    for (int spin = 0;
         spin < std::min(kWakeSpins, m_spins) && isAnyRemaining() && m_awake.load(std::memory_order_relaxed) > 0;
         ++spin)
        pauseBetweenLooks();
}

std::size_t ThreadPool::takeRemainingChunks() {
    std::uint64_t bits = m_remaining.load(std::memory_order_acquire);
    while (true) {
        Remaining remaining = unpacked(bits);
        const std::uint32_t end = std::exchange(remaining.end, remaining.first);
        if (m_remaining.compare_exchange_weak(bits, packed(remaining), std::memory_order_acq_rel)) return end;
    }
}

void ThreadPool::runStagesOnThreads(std::size_t stages, std::size_t parts, const StageWork& work) {
    for (Progress& progress : m_progress) progress.stages.store(0, std::memory_order_relaxed);
    // One counter per part, in its own cache line: a shared counter would bounce between caches.
    const auto finish = [&](std::size_t stage, std::size_t part) {
        m_progress[part].stages.store(static_cast<std::uint32_t>(stage + 1), std::memory_order_release);
    };
    const auto waitForAll = [&](std::size_t stage) {
        for (std::size_t part = 0; part < parts; ++part) {
            waitUntil([&] { return m_progress[part].stages.load(std::memory_order_acquire) > stage; });
        }
    };
    const auto attempt = [&](std::size_t stage, std::size_t part) {
        if (m_hasFailed.load(std::memory_order_relaxed)) return;
        try {
            work(stage, part);
        } catch (...) {
            keepException();
        }
    };
    const auto runPart = [&](std::size_t part) {
        for (std::size_t stage = 0; stage < stages; ++stage) {
            attempt(stage, part);
            finish(stage, part);
            if (stage + 1 < stages) waitForAll(stage);
        }
    };
    const std::function<void(std::size_t)> runPartReference = std::cref(runPart);  // a copy would allocate
    open(runPartReference, 1, parts);
    std::size_t end = 1;  // the caller runs the parts [0, end)
    for (std::size_t stage = 0; stage < stages; ++stage) {
        attempt(stage, 0);
        if (stage == 0) {
            waitForAwakeWorkers();
            end = takeRemainingChunks();
        }
        for (std::size_t part = 1; part < end; ++part) attempt(stage, part);
        for (std::size_t part = 0; part < end; ++part) finish(stage, part);
        if (stage + 1 < stages) waitForAll(stage);
    }
    waitUntil([&] { return m_done.load(std::memory_order_acquire) == parts - end; });
    throwKept();
}

}  // namespace rubble
