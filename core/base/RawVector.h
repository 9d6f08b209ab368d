#pragma once

#include "core/base/LargeMemory.h"

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace rubble {

/// An allocator that leaves new elements unset where no value is given for them, and puts many on large pages.
template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    UnsetAllocator() = default;
    template <class U>
    UnsetAllocator(const UnsetAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (count * sizeof(T) < kLeastForLargePages) return std::allocator<T>::allocate(count);
        return static_cast<T*>(allocateLarge(count * sizeof(T)));
    }
    void deallocate(T* values, std::size_t count) {
        if (count * sizeof(T) < kLeastForLargePages) return std::allocator<T>::deallocate(values, count);
        freeLarge(values);
    }

    /// Plain values need no constructor; one that gives their members defaults would write all of them.
    template <class U>
    void construct(U* place) {
        if constexpr (!std::is_trivially_copyable_v<U>) ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose resize() does not write: for large arrays of plain values that several threads fill in.
template <class T>
using RawVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace rubble
