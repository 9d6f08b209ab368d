#include "core/base/Parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace rubble {

int availableProcessors() { return tbb::info::default_concurrency(); }

void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work) {
    // TBB prints a warning where it is asked for more threads than there are processors.
    tbb::task_arena arena(std::min(threads, availableProcessors()));
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t index = range.begin(); index < range.end(); ++index) work(index);
            },
            tbb::simple_partitioner());
    });
}

}  // namespace rubble
