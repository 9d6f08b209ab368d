#pragma once

#include "core/base/Parallel.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace rubble {

/// Threads that stay at hand from step to step. A step has hundreds of short stages; the caller's thread goes through all of them,
/// and the others take chunks of a stage when they are there: who has no processor at the moment is not waited for. Between stages
/// they spin for a moment, since a wait in the system costs more than most stages. The caller takes chunks from the first on and
/// the others from the last back, so that from stage to stage each finds most of what it needs in its own cache.
class WorkerTeam {
public:
    /// `size` workers, the caller's thread among them.
    explicit WorkerTeam(int size);
    ~WorkerTeam();
    WorkerTeam(const WorkerTeam&) = delete;
    WorkerTeam& operator=(const WorkerTeam&) = delete;

    int size() const { return static_cast<int>(m_threads.size()) + 1; }
    /// Into how many chunks work on `count` things is cut, each of `least` at least: 1 where it is not worth sharing.
    std::size_t chunksOf(std::size_t count, std::size_t least) const;

    /// Calls work(range, chunk) once for each of `chunks` parts of [0, count), in order of their numbers where the caller is alone;
    /// returns when all are done. What is gathered by chunk is in the order of the whole, however many chunks there are.
    template <class Work>
    void share(std::size_t count, std::size_t chunks, const Work& work) {
        const auto one = [&](std::size_t chunk) { work(partOf(count, chunk, chunks), chunk); };
        if (chunks == 1 || m_threads.empty()) {
            for (std::size_t chunk = 0; chunk < chunks; ++chunk) one(chunk);
        } else {
            shareChunks(chunks, std::ref(one));
        }
    }

private:
    void shareChunks(std::size_t chunks, const std::function<void(std::size_t)>& work);
    void takeChunks(std::uint32_t stage, bool isCaller);
    void serve();

    std::vector<std::thread> m_threads;
    const std::function<void(std::size_t)>* m_work = nullptr;
    std::uint32_t m_chunks = 0;
    // The stage and the chunks [first, end) that are left of it: who comes late takes none of the stage after.
    alignas(64) std::atomic<std::uint64_t> m_left{0};
    alignas(64) std::atomic<std::uint32_t> m_stage{0};
    alignas(64) std::atomic<std::uint32_t> m_done{0};  // chunks
    std::atomic<bool> m_isEnding{false};
};

}  // namespace rubble
