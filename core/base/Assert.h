#pragma once

namespace rubble {

/// Prints the failed condition and its location to stderr and aborts.
[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);

}  // namespace rubble

/// Checks an internal invariant, in builds with RUBBLE_ASSERTS. Invalid input from outside is a Result instead.
#ifdef RUBBLE_ASSERTS
#define RUBBLE_ASSERT(condition) \
    (static_cast<bool>(condition) ? void() : ::rubble::assertionFailed(#condition, __FILE__, __LINE__))
#else
#define RUBBLE_ASSERT(condition) static_cast<void>(sizeof(static_cast<bool>(condition)))
#endif
