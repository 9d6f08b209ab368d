#include "core/base/LargeMemory.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rubble {

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;  // bytes

}  // namespace

void* allocateLarge(std::size_t bytes) {
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* const memory = std::aligned_alloc(kLargePage, whole);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    // No more than advice: where it is not taken, nothing changes.
    madvise(memory, whole, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeLarge(void* memory) { std::free(memory); }

}  // namespace rubble
