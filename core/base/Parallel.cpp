#include "core/base/Parallel.h"

#include "core/base/HappensBefore.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace rubble {
namespace {

constexpr char kLoops = 0;

}  // namespace

int availableProcessors() { return tbb::info::default_concurrency(); }

void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work) {
    // TBB prints a warning where it is asked for more threads than there are processors.
    tbb::task_arena arena(std::min(threads, availableProcessors()));
    const auto body = [&](const tbb::blocked_range<std::size_t>& range) {
        receivedFrom(&kLoops);
        for (std::size_t index = range.begin(); index < range.end(); ++index) work(index);
        handedOver(&kLoops);
    };
    const auto loop = [&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), body, tbb::simple_partitioner());
    };
    handedOver(&kLoops);
    arena.execute(loop);
    receivedFrom(&kLoops);
}

}  // namespace rubble
