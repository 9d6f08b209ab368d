#pragma once

#include "core/base/Parallel.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace rubble {

/// Threads that stay at hand from step to step. A step has hundreds of short stages: workers meet at a barrier after each, and spin
/// there, since a wait in the system costs more than most stages.
class WorkerTeam {
public:
    /// `size` workers, the caller's thread among them.
    explicit WorkerTeam(int size);
    ~WorkerTeam();
    WorkerTeam(const WorkerTeam&) = delete;
    WorkerTeam& operator=(const WorkerTeam&) = delete;

    int size() const { return static_cast<int>(m_threads.size()) + 1; }

    /// Calls work(worker) once on each worker; returns when all are done.
    template <class Work>
    void run(const Work& work) {
        if (m_threads.empty()) return work(0);
        runOnAll(std::cref(work));
    }
    /// Calls work(range, worker) for parts of [0, count), a part each worker; by the caller alone where a part would be smaller than
    /// `least`.
    template <class Work>
    void share(std::size_t count, std::size_t least, const Work& work) {
        if (m_threads.empty() || count < least * static_cast<std::size_t>(size())) {
            if (count > 0) work(IndexRange{0, count}, 0);
            return;
        }
        run([&](int worker) {
            const IndexRange range = partOf(count, static_cast<std::size_t>(worker), static_cast<std::size_t>(size()));
            if (range.size() > 0) work(range, worker);
        });
    }
    /// Within run(): waits until all workers have come here.
    void meet();

private:
    void runOnAll(const std::function<void(int)>& work);
    void serve(int worker);

    std::vector<std::thread> m_threads;
    const std::function<void(int)>* m_work = nullptr;
    alignas(64) std::atomic<std::uint32_t> m_round{0};    // counts calls of run()
    alignas(64) std::atomic<std::uint32_t> m_arrived{0};  // at the barrier
    alignas(64) std::atomic<std::uint32_t> m_meeting{0};  // counts meetings
    bool m_isEnding = false;
};

}  // namespace rubble
