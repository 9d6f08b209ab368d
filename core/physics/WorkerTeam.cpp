#include "core/physics/WorkerTeam.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Some ten microseconds: stages of a step follow each other faster than that.
constexpr int kSpins = 4000;
/// A microsecond or two, in which a worker that is awake has seen that there is work.
constexpr int kPatience = 64;
/// Chunks a worker, so that one that is late leaves less behind.
constexpr std::size_t kChunksAWorker = 4;

struct Left {
    std::uint32_t stage;
    std::uint32_t first;
    std::uint32_t end;
};
constexpr unsigned kChunkBits = 16;
constexpr std::uint64_t kChunkMask = (1u << kChunkBits) - 1;

std::uint64_t packed(const Left& left) {
    return std::uint64_t{left.stage} << (2 * kChunkBits) | std::uint64_t{left.first} << kChunkBits | left.end;
}
Left unpacked(std::uint64_t bits) {
    return {static_cast<std::uint32_t>(bits >> (2 * kChunkBits)),
            static_cast<std::uint32_t>(bits >> kChunkBits & kChunkMask), static_cast<std::uint32_t>(bits & kChunkMask)};
}

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

WorkerTeam::WorkerTeam(int size)
    : m_arrivals(static_cast<std::size_t>(std::max(size, 1))),
      m_spins(std::cmp_less_equal(size, std::thread::hardware_concurrency()) ? kSpins : 0) {
    for (int worker = 1; worker < size; ++worker) m_threads.emplace_back([this] { serve(); });
}

WorkerTeam::~WorkerTeam() {
    m_isEnding.store(true, std::memory_order_relaxed);
    m_stage.fetch_add(1, std::memory_order_release);
    m_stage.notify_all();
    for (std::thread& thread : m_threads) thread.join();
}

std::size_t WorkerTeam::chunksOf(std::size_t count, std::size_t least) const {
    const std::size_t workers = m_threads.size() + 1;
    if (workers == 1 || count < 2 * least) return 1;
    return std::min(count / least, kChunksAWorker * workers);
}

void WorkerTeam::serve() {
    std::uint32_t seen = 0;
    m_awake.fetch_add(1, std::memory_order_relaxed);
    while (true) {
        for (int spin = 0; spin < m_spins && m_stage.load(std::memory_order_acquire) == seen; ++spin) pause();
        if (m_stage.load(std::memory_order_acquire) == seen) {
            m_awake.fetch_sub(1, std::memory_order_relaxed);
            m_stage.wait(seen, std::memory_order_acquire);
            m_awake.fetch_add(1, std::memory_order_relaxed);
        }
        seen = m_stage.load(std::memory_order_acquire);
        if (m_isEnding.load(std::memory_order_relaxed)) return;
        takeChunks(seen, false);
    }
}

void WorkerTeam::takeChunks(std::uint32_t stage, bool isCaller) {
    std::uint64_t bits = m_left.load(std::memory_order_acquire);
    while (true) {
        Left left = unpacked(bits);
        if (left.stage != stage || left.first == left.end) return;
        const std::uint32_t chunk = isCaller ? left.first++ : --left.end;
        if (!m_left.compare_exchange_weak(bits, packed(left), std::memory_order_acq_rel)) continue;
        (*m_work)(chunk);
        m_done.fetch_add(1, std::memory_order_release);
        bits = m_left.load(std::memory_order_acquire);
    }
}

std::uint32_t WorkerTeam::open(const std::function<void(std::size_t)>& work, std::size_t first, std::size_t chunks) {
    const std::uint32_t stage = m_stage.load(std::memory_order_relaxed) + 1;
    m_work = &work;
    m_done.store(0, std::memory_order_relaxed);
    m_left.store(packed({stage, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(chunks)}),
                 std::memory_order_release);
    m_stage.store(stage, std::memory_order_release);
    m_stage.notify_all();
    return stage;
}

template <class IsOver>
void WorkerTeam::waitUntil(const IsOver& isOver) const {
    for (int spin = 0; !isOver(); ++spin) {
        if (spin < m_spins) {
            pause();
        } else {
            std::this_thread::yield();
        }
    }
}

void WorkerTeam::shareChunks(std::size_t chunks, const std::function<void(std::size_t)>& work) {
    takeChunks(open(work, 0, chunks), true);
    waitUntil([&] { return m_done.load(std::memory_order_acquire) == chunks; });
}

void WorkerTeam::waitForTheAwake() const {
    const auto isAnyLeft = [&] {
        const Left left = unpacked(m_left.load(std::memory_order_acquire));
        return left.first < left.end;
    };
    for (int spin = 0;
         spin < std::min(kPatience, m_spins) && isAnyLeft() && m_awake.load(std::memory_order_relaxed) > 0; ++spin)
        pause();
}

std::size_t WorkerTeam::takeAllThatIsLeft() {
    std::uint64_t bits = m_left.load(std::memory_order_acquire);
    while (true) {
        Left left = unpacked(bits);
        const std::uint32_t end = std::exchange(left.end, left.first);
        if (m_left.compare_exchange_weak(bits, packed(left), std::memory_order_acq_rel)) return end;
    }
}

void WorkerTeam::sharePartsOfStages(std::size_t stages, std::size_t parts, const StageWork& work) {
    for (Arrival& arrival : m_arrivals) arrival.stages.store(0, std::memory_order_relaxed);
    // Each part tells in a place of its own: one that all count up would go to and fro between their caches.
    const auto arrive = [&](std::size_t stage, std::size_t part) {
        m_arrivals[part].stages.store(static_cast<std::uint32_t>(stage + 1), std::memory_order_release);
    };
    const auto waitForAll = [&](std::size_t stage) {
        for (std::size_t part = 0; part < parts; ++part) {
            waitUntil([&] { return m_arrivals[part].stages.load(std::memory_order_acquire) > stage; });
        }
    };
    const auto others = [&](std::size_t part) {
        for (std::size_t stage = 0; stage < stages; ++stage) {
            work(stage, part);
            arrive(stage, part);
            if (stage + 1 < stages) waitForAll(stage);
        }
    };
    const std::function<void(std::size_t)> takeOne = std::cref(others);  // a copy would take memory
    open(takeOne, 1, parts);
    std::size_t end = 1;  // of the caller's parts
    for (std::size_t stage = 0; stage < stages; ++stage) {
        work(stage, 0);
        if (stage == 0) {
            waitForTheAwake();
            end = takeAllThatIsLeft();
        }
        for (std::size_t part = 1; part < end; ++part) work(stage, part);
        for (std::size_t part = 0; part < end; ++part) arrive(stage, part);
        if (stage + 1 < stages) waitForAll(stage);
    }
    waitUntil([&] { return m_done.load(std::memory_order_acquire) == parts - end; });
}

}  // namespace rubble
