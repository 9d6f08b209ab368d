#pragma once

#include <string>

namespace rubble {

/// A number for a message: the shortest text that parses to the same number, NaN and infinity included, in any locale.
/// Without an exponent from 1e-6 up to 1e15.
std::string messageText(double value);

/// A number with 1 to 17 significant digits.
std::string roundedText(double value, int digits);

}  // namespace rubble
