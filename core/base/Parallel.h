#pragma once

#include <cstddef>
#include <functional>

namespace rubble {

/// forEachIndex() where there are several of both.
void forEachIndexOnThreads(std::size_t count, int threads, const std::function<void(std::size_t index)>& work);

/// Calls `work` once for each index below `count`, on up to `threads` threads, the caller's among them; returns when
/// all are done. Which thread takes which index is open: `work` writes to places of its own index only.
template <class Work>
void forEachIndex(std::size_t count, int threads, const Work& work) {
    if (threads > 1 && count > 1) return forEachIndexOnThreads(count, threads, std::cref(work));
    for (std::size_t index = 0; index < count; ++index) work(index);
}

/// Indices [begin, end) of a larger whole.
struct IndexRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t size() const { return end - begin; }
};

/// Part `part` of [0, count) cut into `parts` parts whose sizes differ by one at most, in order.
inline IndexRange partOf(std::size_t count, std::size_t part, std::size_t parts) {
    const std::size_t least = count / parts, longer = count % parts;
    const std::size_t begin = part * least + (part < longer ? part : longer);
    return {begin, begin + least + (part < longer ? 1 : 0)};
}

}  // namespace rubble
