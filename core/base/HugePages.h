#pragma once

#include <cstddef>

namespace rubble {

/// The smallest allocation, in bytes, that is placed on huge pages: a smaller one would waste too much of its last
/// page.
inline constexpr std::size_t kMinHugePageBytes = std::size_t{1} << 22;

/// Allocates memory on 2 MiB pages if the system supports them, aligned to such a page. Release it by freeHugePages().
/// Saves page faults, which for 4 KiB pages take longer than filling them.
///
/// Errors: throws std::bad_alloc if out of memory, as containers expect.
void* allocateHugePages(std::size_t bytes);
void freeHugePages(void* memory);

}  // namespace rubble
