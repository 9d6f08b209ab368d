#pragma once

#include <cstddef>
#include <functional>

namespace rubble {

/// The number of processors that this process may use, at least 1: fewer than the machine has where it is confined to
/// some of them, as in a container.
int availableProcessors();

/// The implementation of forEachIndex() for several indices and threads.
void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work);

/// Calls `work` once for each index below `count`, on up to `threads` threads including the caller's, one for each
/// processor at most; returns when all calls have returned. The assignment of indices to threads is unspecified: `work`
/// may write only to data of its own index.
template <class Work>
void forEachIndex(std::size_t count, int threads, const Work& work) {
    if (threads > 1 && count > 1) return forEachIndexOnThreads(count, threads, std::cref(work));
    for (std::size_t index = 0; index < count; ++index) work(index);
}

/// The indices [begin, end).
struct IndexRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t size() const { return end - begin; }
};

/// Chunk `chunk` of [0, count), split into `chunks` consecutive ranges whose sizes differ by at most one.
inline IndexRange chunkRange(std::size_t count, std::size_t chunk, std::size_t chunks) {
    const std::size_t least = count / chunks, longer = count % chunks;
    const std::size_t begin = chunk * least + (chunk < longer ? chunk : longer);
    return {begin, begin + least + (chunk < longer ? 1 : 0)};
}

}  // namespace rubble
