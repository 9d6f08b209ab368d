#pragma once

namespace rubble {

/// Approach speed, m/s, below which a collision does not count as an impact and causes no damage.
inline constexpr float kMinImpactSpeed = 0.5f;
/// Approach speed, m/s, below which there is no restitution.
inline constexpr float kMinRestitutionSpeed = 1.0f;

}  // namespace rubble
