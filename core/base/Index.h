#pragma once

#include <cstdint>

namespace rubble {

/// The index that refers to nothing.
inline constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace rubble
