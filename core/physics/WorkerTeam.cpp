#include "core/physics/WorkerTeam.h"

namespace rubble {
namespace {

/// Some ten microseconds: stages of a step follow each other faster than that.
constexpr int kSpins = 4000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

WorkerTeam::WorkerTeam(int size) {
    for (int worker = 1; worker < size; ++worker) m_threads.emplace_back([this, worker] { serve(worker); });
}

WorkerTeam::~WorkerTeam() {
    m_isEnding = true;
    m_round.fetch_add(1, std::memory_order_release);
    m_round.notify_all();
    for (std::thread& thread : m_threads) thread.join();
}

void WorkerTeam::serve(int worker) {
    std::uint32_t seen = 0;
    while (true) {
        for (int spin = 0; spin < kSpins && m_round.load(std::memory_order_acquire) == seen; ++spin) pause();
        m_round.wait(seen, std::memory_order_acquire);
        seen = m_round.load(std::memory_order_acquire);
        if (m_isEnding) return;
        (*m_work)(worker);
        meet();
    }
}

void WorkerTeam::runOnAll(const std::function<void(int)>& work) {
    m_work = &work;
    m_round.fetch_add(1, std::memory_order_release);
    m_round.notify_all();
    work(0);
    meet();
}

void WorkerTeam::meet() {
    if (m_threads.empty()) return;
    const std::uint32_t meeting = m_meeting.load(std::memory_order_acquire);
    if (m_arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == m_threads.size() + 1) {
        m_arrived.store(0, std::memory_order_relaxed);
        m_meeting.fetch_add(1, std::memory_order_release);
        return;
    }
    for (int spin = 0; m_meeting.load(std::memory_order_acquire) == meeting; ++spin) {
        if (spin < kSpins) {
            pause();
        } else {
            std::this_thread::yield();
        }
    }
}

}  // namespace rubble
