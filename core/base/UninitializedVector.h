#pragma once

#include "core/base/HugePages.h"

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace rubble {

/// An allocator that leaves value-initialized elements uninitialized, and places large arrays on huge pages.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UninitializedAllocator<U>;
    };
    UninitializedAllocator() = default;
    template <class U>
    UninitializedAllocator(const UninitializedAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (count * sizeof(T) < kMinHugePageBytes) return std::allocator<T>::allocate(count);
        return static_cast<T*>(allocateHugePages(count * sizeof(T)));
    }
    void deallocate(T* values, std::size_t count) {
        if (count * sizeof(T) < kMinHugePageBytes) return std::allocator<T>::deallocate(values, count);
        freeHugePages(values);
    }

    /// Skips the constructor of trivially copyable types, whose default member initializers would write every element.
    template <class U>
    void construct(U* address) {
        if constexpr (!std::is_trivially_copyable_v<U>) ::new (static_cast<void*>(address)) U;
    }
    template <class U, class... Arguments>
    void construct(U* address, Arguments&&... arguments) {
        ::new (static_cast<void*>(address)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose resize() leaves new elements uninitialized: for large arrays of plain values that several threads
/// fill.
template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}  // namespace rubble
