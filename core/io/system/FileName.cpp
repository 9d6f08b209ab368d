#include "core/io/system/FileName.h"

#include <string_view>

namespace rubble {

std::string safeFileName(const std::string& name) {
    std::string safe = name;
    for (char& letter : safe) {
        const auto code = static_cast<unsigned char>(letter);
        const bool isAlphanumeric = (code >= '0' && code <= '9') || ((code | 32) >= 'a' && (code | 32) <= 'z');
        if (!isAlphanumeric && code < 0x80 && std::string_view("-_. ").find(letter) == std::string_view::npos)
            letter = '_';
    }
    for (const std::size_t end : {std::size_t{0}, safe.size() - 1}) {
        if (!safe.empty() && (safe[end] == '.' || safe[end] == ' ')) safe[end] = '_';
    }
    return safe.empty() ? "_" : safe;
}

}  // namespace rubble
