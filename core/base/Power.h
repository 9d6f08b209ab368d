#pragma once

namespace rubble {

/// base^exponent for base >= 0, exponent >= 0 where the base is zero; off by less than 1e-14 of the result for each e that
/// the result is a power of. The same bits on every machine, which the C library's does not promise. Zero to the power of zero is 1.
///
/// Source: the series of atanh and exp; Cody, Waite 1980 for the reduction by ln 2 in two parts.
double power(double base, double exponent);

}  // namespace rubble
