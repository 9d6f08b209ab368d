#pragma once

namespace rubble {

inline constexpr double kFullTurn = 6.283185307179586;  // rad: 2 pi, rounded to a double

/// The largest magnitude of an angle that sine and cosine accept, rad.
inline constexpr double kMaxAngle = 1e6;

/// Sine and cosine of an angle in radians, |angle| <= kMaxAngle, with an error below 1 ulp. The same bits on every
/// machine, unlike the C library's.
///
/// Source: Cody, Waite 1980 (reduction by pi/2 in parts); the polynomials of fdlibm, Sun Microsystems 1993.
double sine(double angle);
double cosine(double angle);

/// The angle of the point (x, y), counterclockwise from the x axis, in [-pi, pi], with an error below 1e-15 of a full
/// turn; 0 for the origin. The same bits on every machine, unlike the C library's atan2.
double angleOf(double y, double x);

}  // namespace rubble
