#pragma once

#include <cstddef>

namespace rubble {

/// Bytes from which memory is worth large pages: less would waste too much of the last one.
inline constexpr std::size_t kLeastForLargePages = std::size_t{1} << 22;

/// Memory on pages of 2 MiB where the system has them, aligned to such a page; to be given to freeLarge. The first touch of
/// a page interrupts the program, which for pages of 4 KiB takes longer than to fill them.
///
/// Errors: throws std::bad_alloc where no memory is left, as containers expect.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory);

}  // namespace rubble
