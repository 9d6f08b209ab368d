#pragma once

namespace rubble {

/// How often a thread that waits for another looks before it lets the kernel wake it: about ten microseconds. The
/// stages of a step, and the loops of a fracture, follow each other faster than the kernel wakes threads.
inline constexpr int kSpins = 4000;

/// What a waiting thread does between two looks.
inline void pauseBetweenLooks() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

}  // namespace rubble
