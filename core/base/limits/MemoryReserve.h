#pragma once

#include <cstddef>

namespace rubble {

/// Holds back some address space (a few dozen MiB) which is released when an allocation fails, so that what unwinds,
/// and libraries that cannot do without memory, find some. Takes no physical memory. Holding it again while it is held,
/// or where there is no room for it, does nothing.
void holdMemoryReserve() noexcept;

/// Releases what is held, if anything; from any thread.
void releaseMemoryReserve() noexcept;

/// Whether so many bytes of address space are left: for libraries that crash without.
bool isAddressSpaceLeft(std::size_t bytes) noexcept;

/// Whether the reserve is held: false from a failed allocation until it is held again.
bool isMemoryReserveHeld() noexcept;

}  // namespace rubble
