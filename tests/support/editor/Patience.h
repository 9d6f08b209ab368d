#pragma once

namespace rubble {

inline constexpr int kPatience = 60000;  // ms, for baking and drawing on a busy machine

}  // namespace rubble
