#include "core/physics/WorkerTeam.h"

#include <algorithm>

namespace rubble {
namespace {

/// Some ten microseconds: stages of a step follow each other faster than that.
constexpr int kSpins = 4000;
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

WorkerTeam::WorkerTeam(int size) {
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
    while (true) {
        for (int spin = 0; spin < kSpins && m_stage.load(std::memory_order_acquire) == seen; ++spin) pause();
        m_stage.wait(seen, std::memory_order_acquire);
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

void WorkerTeam::shareChunks(std::size_t chunks, const std::function<void(std::size_t)>& work) {
    const std::uint32_t stage = m_stage.load(std::memory_order_relaxed) + 1;
    m_work = &work;
    m_chunks = static_cast<std::uint32_t>(chunks);
    m_done.store(0, std::memory_order_relaxed);
    m_left.store(packed({stage, 0, m_chunks}), std::memory_order_release);
    m_stage.store(stage, std::memory_order_release);
    m_stage.notify_all();
    takeChunks(stage, true);
    for (int spin = 0; m_done.load(std::memory_order_acquire) != m_chunks; ++spin) {
        if (spin < kSpins) {
            pause();
        } else {
            std::this_thread::yield();
        }
    }
}

}  // namespace rubble
