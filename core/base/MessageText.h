#pragma once

#include <string>

namespace rubble {

/// A number as it stands in a sentence for the user: the shortest text that reads back as the same number, NaN and
/// infinity included, the same in every locale. Without an exponent from a millionth up to 1e15.
std::string messageText(double value);

/// A measured number with as many significant digits as a reader wants, 1 to 17.
std::string roundedText(double value, int digits);

}  // namespace rubble
