#pragma once

namespace rubble {

/// Approach speed, m/s, below which a collision does not count as an impact and causes no damage.
inline constexpr float kMinImpactSpeed = 0.5f;
/// Approach speed, m/s, below which there is no restitution.
inline constexpr float kMinRestitutionSpeed = 1.0f;

/// The fastest that contacts spin a body, rad/s: splinters of a tenth of a millimetre that roll at 10 m/s.
inline constexpr float kMaxSpin = 1e5f;

}  // namespace rubble
