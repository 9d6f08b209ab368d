#pragma once

#include <cstdint>

namespace rubble {

/// No index: nobody, nowhere, none of them.
inline constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace rubble
