#include "core/io/system/FileName.h"

#include "core/base/Assert.h"
#include "core/base/Hash.h"
#include "core/io/system/UnicodeName.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace rubble {
namespace {

constexpr std::size_t kMaxName = 255;        // bytes
constexpr std::size_t kWholeHash = 100;      // bytes: a shorter name gets only the start of its hash,
constexpr std::size_t kShortHashDigits = 8;  // so many digits

/// Names that Windows keeps for devices, in every folder and with any ending.
/// Source: Microsoft, "Naming Files, Paths, and Namespaces". "CONIN$" and "CONOUT$" have a character that is replaced.
constexpr std::array<std::string_view, 4> kDevices = {"con", "prn", "aux", "nul"};
constexpr std::array<std::string_view, 2> kNumberedDevices = {"com", "lpt"};  // and a digit, also ¹, ² or ³

/// Returns the name, or its first characters and a hash of the whole if it has more than `size` bytes.
std::string shortened(const std::string& name, std::size_t size) {
    if (name.size() <= size) return name;
    std::string hash = "-" + contentHash(name).hex();
    if (size < kWholeHash) hash.resize(1 + kShortHashDigits);
    std::size_t kept = size - hash.size();
    while (kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0) == 0x80) --kept;  // not inside of UTF-8
    return name.substr(0, kept) + hash;
}

/// The same, by the length that the strictest file system counts.
std::string shortenedSafeName(const std::string& name, std::size_t most) {
    std::string result = name;
    for (std::size_t size = most; nameLength(result) > most; size -= 8) result = shortened(name, size);
    return result;
}

bool isAllowedAscii(char32_t code) {
    const bool isLetter = (code | 32) >= U'a' && (code | 32) <= U'z';
    return isLetter || (code >= U'0' && code <= U'9') ||
           std::u32string_view(U"-_. ").find(code) != std::u32string::npos;
}

/// The character of a file name for one of a name.
char32_t safeCharacter(char32_t code) {
    if (code < 0x80) return isAllowedAscii(code) ? code : U'_';
    switch (nameCharacterOf(code)) {
        case NameCharacter::Visible: return code;
        case NameCharacter::Space: return U' ';
        case NameCharacter::Invisible: break;
    }
    return U'_';
}

/// Whether Windows takes a name for that of a device. It looks at what comes before the first dot, without spaces
/// behind it, in any case; the key also makes digits of "¹", "²" and "³".
bool isDevice(const std::string& name) {
    const std::size_t end = name.substr(0, name.find('.')).find_last_not_of(' ');
    const std::string key = end == std::string::npos ? std::string() : nameKey(name.substr(0, end + 1));
    if (std::ranges::find(kDevices, key) != kDevices.end()) return true;
    const bool isNumbered = key.size() == 4 && key[3] >= '0' && key[3] <= '9';
    return isNumbered && std::ranges::find(kNumberedDevices, key.substr(0, 3)) != kNumberedDevices.end();
}

}  // namespace

std::string safeFileName(const std::string& name, std::size_t most) {
    RUBBLE_ASSERT(most >= kShortestName && most <= kLongestName);
    std::u32string codes = composedCodePoints(name);
    std::ranges::transform(codes, codes.begin(), safeCharacter);
    if (codes.empty()) return "_";
    for (char32_t* end : {&codes.front(), &codes.back()}) {
        if (*end == U'.' || *end == U' ') *end = U'_';
    }
    if (codes.front() == U'-') codes.front() = U'_';
    const std::string safe = utf8Of(codes);
    return shortenedSafeName(isDevice(safe) ? "_" + safe : safe, most);
}

std::vector<std::string> distinctFileNames(std::span<const std::string> names, std::size_t most) {
    std::set<std::string> taken;  // keys
    std::vector<std::string> result;
    std::vector<std::size_t> doubles;
    for (const std::string& name : names) {
        result.push_back(safeFileName(name, most));
        if (!taken.insert(nameKey(result.back())).second) doubles.push_back(result.size() - 1);
    }
    for (const std::size_t k : doubles) {
        const std::string start = result[k] + '-';
        for (int number = 2;; ++number) {
            result[k] = start + std::to_string(number);
            if (taken.insert(nameKey(result[k])).second) break;
        }
    }
    return result;
}

std::string fittingFileName(const std::string& start, const std::string& name, const std::string& end) {
    return start + shortened(name, kMaxName - start.size() - end.size()) + end;
}

}  // namespace rubble
