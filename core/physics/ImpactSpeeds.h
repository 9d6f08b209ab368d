#pragma once

namespace rubble {

inline constexpr float kImpactSpeed = 0.5f;       // m/s of approach: slower, and nothing is hurt
inline constexpr float kRestitutionSpeed = 1.0f;  // m/s of approach: slower, and nothing is thrown back

}  // namespace rubble
