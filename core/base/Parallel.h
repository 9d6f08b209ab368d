#pragma once

#include <cstddef>
#include <functional>

namespace rubble {

/// Calls `work` once for each index below `count`, on up to `threads` threads, the caller's among them; returns when
/// all are done. Which thread takes which index is open: `work` writes to places of its own index only.
void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t index)>& work);

}  // namespace rubble
