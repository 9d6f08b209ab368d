#include "core/io/system/FileName.h"

#include "core/base/Hash.h"

#include <string_view>

namespace rubble {
namespace {

constexpr std::size_t kMaxName = 255;      // bytes
constexpr std::size_t kMaxSafeName = 200;  // the same

/// Returns the name, or its first characters and a hash of the whole if it has more than `size` bytes.
std::string shortened(const std::string& name, std::size_t size) {
    if (name.size() <= size) return name;
    const std::string hash = "-" + contentHash(name).hex();
    std::size_t kept = size - hash.size();
    while (kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0) == 0x80) --kept;  // not inside of UTF-8
    return name.substr(0, kept) + hash;
}

}  // namespace

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
    return safe.empty() ? "_" : shortened(safe, kMaxSafeName);
}

std::string fittingFileName(const std::string& start, const std::string& name, const std::string& end) {
    return start + shortened(name, kMaxName - start.size() - end.size()) + end;
}

}  // namespace rubble
