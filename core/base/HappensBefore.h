#pragma once

#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace rubble {

/// Tells ThreadSanitizer that what this thread did so far happens before what another does after receivedFrom() with
/// the same address: for synchronization by libraries that are not instrumented, such as Qt. Does nothing in other
/// builds.
inline void handedOver([[maybe_unused]] const void* address) {
#ifdef __SANITIZE_THREAD__
    __tsan_release(const_cast<void*>(address));
#endif
}

/// The other side of handedOver().
inline void receivedFrom([[maybe_unused]] const void* address) {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(const_cast<void*>(address));
#endif
}

}  // namespace rubble
