#include "core/base/Parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace rubble {

void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work) {
    tbb::task_arena arena(threads);
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
