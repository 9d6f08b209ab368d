#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

// Replaces operator new of a test program, which is to include this once and to be one of those that rubble_tests()
// lists as ALONE: an allocation fails where FailingAllocation says so.

namespace rubble {

/// Lets one allocation of at least `least` bytes fail, on any thread: the one with the number `failing`, from 1.
class FailingAllocation {
public:
    FailingAllocation(std::size_t least, long failing) {
        s_hasFailed = false;
        s_least = least;
        s_left = failing;
    }
    ~FailingAllocation() { s_left = 0; }
    FailingAllocation(const FailingAllocation&) = delete;
    FailingAllocation& operator=(const FailingAllocation&) = delete;

    /// Whether there were so many.
    static bool hasFailed() { return s_hasFailed; }
    static bool fails(std::size_t size) {
        if (s_left.load(std::memory_order_relaxed) <= 0 || size < s_least || s_left.fetch_sub(1) != 1) return false;
        s_hasFailed = true;
        return true;
    }

private:
    static inline std::atomic<std::size_t> s_least{0};
    static inline std::atomic<long> s_left{0};
    static inline std::atomic<bool> s_hasFailed{false};
};

inline void* allocatedOrNone(std::size_t size, std::size_t alignment) {
    const std::size_t bytes = size == 0 ? 1 : size;
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

inline void* allocated(std::size_t size, std::size_t alignment) {
    void* const memory = FailingAllocation::fails(size) ? nullptr : allocatedOrNone(size, alignment);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace rubble

void* operator new(std::size_t size) { return rubble::allocated(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return rubble::allocated(size, static_cast<std::size_t>(alignment));
}
// Never fails: only libraries ask for memory like this, and the compiler of a software renderer's shaders crashes
// without it.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return rubble::allocatedOrNone(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
