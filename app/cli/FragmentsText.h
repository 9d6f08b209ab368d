#pragma once

#include <cstddef>
#include <string>

namespace rubble {

/// "8 fragments, 0.5 m^3": how a summary tells of what was broken. The volume has four digits.
std::string fragmentsText(std::size_t count, double volume);

}  // namespace rubble
