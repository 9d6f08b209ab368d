#pragma once

#include <cstddef>
#include <string>

namespace rubble {

/// Returns the number of fragments and their volume: "8 fragments, 0.5 m³".
std::string fragmentsText(std::size_t count, double volume);

}  // namespace rubble
