#include "core/base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace rubble {

void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t index)>& work) {
    std::atomic<std::size_t> next{0};
    const auto takeWork = [&] {
        for (std::size_t index = next++; index < count; index = next++) work(index);
    };
    const std::size_t helpers = std::min(count, static_cast<std::size_t>(std::max(threads, 1))) - (count > 0 ? 1 : 0);
    std::vector<std::jthread> pool;  // joins at the end of the scope
    pool.reserve(helpers);
    for (std::size_t helper = 0; helper < helpers; ++helper) pool.emplace_back(takeWork);
    takeWork();
}

}  // namespace rubble
