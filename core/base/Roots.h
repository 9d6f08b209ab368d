#pragma once

namespace rubble {

/// The cube root of a number > 0, to the last bit or the one before; the same bits on every machine, which the C library's
/// does not promise.
double cubeRoot(double number);

}  // namespace rubble
