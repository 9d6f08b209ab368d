#include "app/cli/FragmentsText.h"

#include <charconv>
#include <string_view>

namespace rubble {

std::string fragmentsText(std::size_t count, double volume) {
    char digits[16];
    const char* end = std::to_chars(digits, digits + sizeof digits, volume, std::chars_format::general, 4).ptr;
    const std::string_view volumeText(digits, static_cast<std::size_t>(end - digits));
    return std::to_string(count) + (count == 1 ? " fragment, " : " fragments, ") + std::string(volumeText) + " m^3";
}

}  // namespace rubble
