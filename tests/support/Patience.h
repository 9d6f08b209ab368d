#pragma once

namespace rubble {

/// How long a test waits for something to become true, ms: far longer than it takes on a machine ten times slower than
/// today's, or as busy. No test depends on the speed of the machine but by this limit.
inline constexpr int kPatience = 180'000;

}  // namespace rubble
