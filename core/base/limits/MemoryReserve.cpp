#include "core/base/limits/MemoryReserve.h"

#include <atomic>
#include <cstddef>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rubble {
namespace {

/// More than mimalloc asks the system for at once, which is 32 MiB, aligned.
constexpr std::size_t kBytes = std::size_t{96} << 20;

std::atomic<void*> s_reserve{nullptr};

}  // namespace

void holdMemoryReserve() noexcept {
#ifdef __linux__
    if (s_reserve.load()) return;
    void* const memory = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    void* none = nullptr;
    if (!s_reserve.compare_exchange_strong(none, memory)) munmap(memory, kBytes);  // another thread was faster
#endif
}

void releaseMemoryReserve() noexcept {
#ifdef __linux__
    if (void* const memory = s_reserve.exchange(nullptr)) munmap(memory, kBytes);
#endif
}

bool isAddressSpaceLeft([[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
    void* const memory = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) return false;
    munmap(memory, bytes);
#endif
    return true;
}

bool isMemoryReserveHeld() noexcept { return s_reserve.load() != nullptr; }

}  // namespace rubble
