#pragma once

#include <string>

namespace rubble {

/// A number as it stands in a sentence for the user: the shortest text that reads back as the same number, NaN and
/// infinity included, the same in every locale.
std::string messageText(double value);

}  // namespace rubble
