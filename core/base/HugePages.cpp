#include "core/base/HugePages.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rubble {

namespace {

constexpr std::size_t kHugePageSize = std::size_t{1} << 21;  // bytes

}  // namespace

void* allocateHugePages(std::size_t bytes) {
    const std::size_t whole = (bytes + kHugePageSize - 1) / kHugePageSize * kHugePageSize;
    void* const memory = std::aligned_alloc(kHugePageSize, whole);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    // Only a hint: failure changes nothing.
    madvise(memory, whole, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeHugePages(void* memory) { std::free(memory); }

}  // namespace rubble
