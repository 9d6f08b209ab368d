#pragma once

namespace rubble {

/// The cube root of a number > 0, with an error of at most 2 ulp; the same bits on every machine, unlike the C
/// library's cbrt.
double cubeRoot(double number);

}  // namespace rubble
