#pragma once

namespace rubble {

/// base^exponent for base >= 0; requires exponent >= 0 if the base is zero, and 0^0 is 1. The relative error is below
/// 1e-14 times 1 + |ln result|. The same bits on every machine, unlike the C library's pow.
///
/// Source: the series of atanh and exp; Cody, Waite 1980 for the reduction by ln 2 in two parts.
double power(double base, double exponent);

}  // namespace rubble
