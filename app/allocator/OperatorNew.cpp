// The operators new and delete of the programs, over mimalloc: docs/adr/0023. mimalloc's own operator new ends the
// process where memory runs out, as it is compiled as C, and C cannot throw.
#include "core/base/limits/MemoryReserve.h"

#include <mimalloc.h>

#include <cstddef>
#include <new>

namespace {

/// What std::new_handler is for, and the reserve is released.
///
/// Errors: throws std::bad_alloc.
[[gnu::noinline, gnu::cold]] void* allocateAgain(std::size_t size, std::size_t alignment) {
    while (const std::new_handler handler = std::get_new_handler()) {
        handler();
        if (void* const memory = mi_malloc_aligned(size, alignment)) return memory;
    }
    rubble::releaseMemoryReserve();
    throw std::bad_alloc();
}

[[gnu::noinline, gnu::cold]] void* allocateAgainOrNone(std::size_t size, std::size_t alignment) noexcept {
    try {
        return allocateAgain(size, alignment);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

constexpr std::size_t kAlignment = alignof(std::max_align_t);

std::size_t bytes(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t size) {
    if (void* const memory = mi_malloc(size)) [[likely]]
        return memory;
    return allocateAgain(size, kAlignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (void* const memory = mi_malloc(size)) [[likely]]
        return memory;
    return allocateAgainOrNone(size, kAlignment);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    if (void* const memory = mi_malloc_aligned(size, bytes(alignment))) [[likely]]
        return memory;
    return allocateAgain(size, bytes(alignment));
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    if (void* const memory = mi_malloc_aligned(size, bytes(alignment))) [[likely]]
        return memory;
    return allocateAgainOrNone(size, bytes(alignment));
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new[](std::size_t size, const std::nothrow_t& none) noexcept { return operator new(size, none); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return operator new(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t& none) noexcept {
    return operator new(size, alignment, none);
}

void operator delete(void* memory) noexcept { mi_free(memory); }
void operator delete(void* memory, std::size_t) noexcept { mi_free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { mi_free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { mi_free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { mi_free(memory); }
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept { mi_free(memory); }
void operator delete[](void* memory) noexcept { mi_free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { mi_free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { mi_free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { mi_free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { mi_free(memory); }
void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept { mi_free(memory); }
