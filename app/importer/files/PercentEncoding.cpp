#include "app/importer/files/PercentEncoding.h"

#include <charconv>

namespace rubble {

std::optional<std::string> percentDecoded(std::string_view uri) {
    if (uri.find('%') == std::string_view::npos) return std::nullopt;
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        unsigned code = 0;
        const std::string_view digits = uri.substr(i + 1, 2);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (digits.size() < 2 || read.ptr != digits.data() + 2 || code == 0) return std::nullopt;
        text += static_cast<char>(code);
        i += 2;
    }
    return text;
}

}  // namespace rubble
