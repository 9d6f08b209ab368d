#pragma once

namespace rubble {

/// Prints where a promise inside the program was broken, then aborts.
[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);

}  // namespace rubble

/// A promise that this program makes to itself. Wrong input from outside is a Result, never this.
#ifdef RUBBLE_ASSERTS
#define RUBBLE_ASSERT(condition) \
    (static_cast<bool>(condition) ? void() : ::rubble::assertionFailed(#condition, __FILE__, __LINE__))
#else
#define RUBBLE_ASSERT(condition) static_cast<void>(sizeof(static_cast<bool>(condition)))
#endif
