#pragma once

namespace rubble {

/// m/s of approach: what meets slower is no impact, and hurts nothing.
inline constexpr float kImpactSpeed = 0.5f;
/// m/s of approach: what meets slower is not thrown back, whatever its restitution.
inline constexpr float kRestitutionSpeed = 1.0f;

}  // namespace rubble
