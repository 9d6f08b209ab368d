#pragma once

#include "core/base/Parallel.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace rubble {

/// A pool of threads for fork-join work with many short stages, such as the hundreds of a simulation step. The calling
/// thread works on every stage; the workers join when they are scheduled, and descheduled workers are not waited for.
/// Between stages workers spin briefly, since blocking in the kernel takes longer than most stages. The caller takes
/// chunks from the front and the workers from the back, so that each finds most of its data in its own cache from stage
/// to stage. Where stages are so short that distributing chunks takes longer than working on them, runStages() keeps
/// each part of all stages on one thread.
///
/// An exception of the work, such as std::bad_alloc, is thrown on by the call that runs it, once all threads have left
/// it; of several exceptions, one. Later stages are left out then.
class ThreadPool {
public:
    /// A pool of `size` threads, including the caller's; of fewer where the system allows no more.
    explicit ThreadPool(int size);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const { return static_cast<int>(m_threads.size()) + 1; }
    /// The number of chunks for `count` items, of at least `least` items each; 1 if several threads would not be
    /// faster.
    std::size_t chunkCount(std::size_t count, std::size_t least) const;

    /// Calls work(range, chunk) once for each of `chunks` consecutive ranges of [0, count), in order if there is one
    /// thread; returns when all calls have returned. Results collected per chunk and concatenated are in the order of
    /// [0, count).
    template <class Work>
    void forEachChunk(std::size_t count, std::size_t chunks, const Work& work) {
        const auto doChunk = [&](std::size_t chunk) { work(chunkRange(count, chunk, chunks), chunk); };
        if (chunks == 1 || m_threads.empty()) {
            for (std::size_t chunk = 0; chunk < chunks; ++chunk) doChunk(chunk);
        } else {
            runChunksOnThreads(chunks, std::ref(doChunk));
        }
    }

    /// Calls work(stage, part) for each of `stages` stages and at most size() `parts`, with a barrier after each stage.
    /// Each part runs on one thread in all stages; parts that no worker has taken when the caller finishes its first
    /// run on the caller.
    template <class Work>
    void runStages(std::size_t stages, std::size_t parts, const Work& work) {
        if (parts == 1) {
            for (std::size_t stage = 0; stage < stages; ++stage) work(stage, 0);
        } else {
            runStagesOnThreads(stages, parts, std::cref(work));
        }
    }

private:
    using StageWork = std::function<void(std::size_t stage, std::size_t part)>;

    void runChunksOnThreads(std::size_t chunks, const std::function<void(std::size_t)>& work);
    void runStagesOnThreads(std::size_t stages, std::size_t parts, const StageWork& work);
    std::uint32_t open(const std::function<void(std::size_t)>& work, std::size_t first, std::size_t chunks);
    void takeChunks(std::uint32_t stage, bool isCaller);
    void waitForAwakeWorkers() const;
    std::size_t takeRemainingChunks();
    template <class IsDone>
    void waitUntil(const IsDone& isDone) const;
    void runWorker();
    void keepException() noexcept;
    void throwKept();

    const std::function<void(std::size_t)>* m_work = nullptr;
    // The stage and its remaining chunks [first, end), in one word: a late worker cannot take chunks of the next stage.
    alignas(64) std::atomic<std::uint64_t> m_remaining{0};
    alignas(64) std::atomic<std::uint32_t> m_stage{0};
    alignas(64) std::atomic<std::uint32_t> m_done{0};  // chunks
    struct alignas(64) Progress {
        std::atomic<std::uint32_t> stages{0};  // of runStages() that a part has finished
    };
    std::vector<Progress> m_progress;
    alignas(64) std::atomic<int> m_awake{0};  // workers that are spinning or working, not blocked
    std::atomic<bool> m_isStopping{false};
    std::atomic<bool> m_hasFailed{false};
    std::exception_ptr m_failure;  // written by the thread that sets m_hasFailed
    int m_spins = 0;               // before a thread yields
    std::vector<std::thread> m_threads;
};

}  // namespace rubble
