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
/// the others from the last back, so that from stage to stage each finds most of what it needs in its own cache; where stages
/// are so short that taking chunks costs more than working on them, a worker keeps to its part of all of them.
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

    /// Calls work(stage, part) for each of `stages` stages and `parts` parts, at most size(): a stage when all parts of the one
    /// before are done. Who takes a part keeps it through all stages; what nobody has taken by the end of the caller's first is
    /// the caller's, too.
    template <class Work>
    void shareStages(std::size_t stages, std::size_t parts, const Work& work) {
        if (parts == 1) {
            for (std::size_t stage = 0; stage < stages; ++stage) work(stage, 0);
        } else {
            sharePartsOfStages(stages, parts, std::cref(work));
        }
    }

private:
    using StageWork = std::function<void(std::size_t stage, std::size_t part)>;

    void shareChunks(std::size_t chunks, const std::function<void(std::size_t)>& work);
    void sharePartsOfStages(std::size_t stages, std::size_t parts, const StageWork& work);
    std::uint32_t open(const std::function<void(std::size_t)>& work, std::size_t first, std::size_t chunks);
    void takeChunks(std::uint32_t stage, bool isCaller);
    void waitForTheAwake() const;
    std::size_t takeAllThatIsLeft();
    template <class IsOver>
    void waitUntil(const IsOver& isOver) const;
    void serve();

    const std::function<void(std::size_t)>* m_work = nullptr;
    // The stage and the chunks [first, end) that are left of it: who comes late takes none of the stage after.
    alignas(64) std::atomic<std::uint64_t> m_left{0};
    alignas(64) std::atomic<std::uint32_t> m_stage{0};
    alignas(64) std::atomic<std::uint32_t> m_done{0};  // chunks
    struct alignas(64) Arrival {
        std::atomic<std::uint32_t> stages{0};  // of shareStages() that a part is through with
    };
    std::vector<Arrival> m_arrivals;
    alignas(64) std::atomic<int> m_awake{
        0};  // of the threads, those that wait for work without having gone to sleep, or work
    std::atomic<bool> m_isEnding{false};
    int m_spins = 0;  // before a worker lets others have the processor
    std::vector<std::thread> m_threads;
};

}  // namespace rubble
