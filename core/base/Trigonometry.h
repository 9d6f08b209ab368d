#pragma once

namespace rubble {

/// The largest magnitude of an angle that sine and cosine take, rad.
inline constexpr double kLargestAngle = 1e6;

/// Sine and cosine of an angle in radians, |angle| <= kLargestAngle, off by less than one unit in the last place. The
/// same bits on every machine, which the C library's do not promise.
///
/// Source: Cody, Waite 1980 (reduction by pi/2 in parts); the polynomials of fdlibm, Sun Microsystems 1993.
double sine(double angle);
double cosine(double angle);

}  // namespace rubble
