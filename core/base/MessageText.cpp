#include "core/base/MessageText.h"

#include "core/base/Utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace rubble {
namespace {

constexpr std::size_t kMaxWidth = 60;     // characters of a name
constexpr std::size_t kMaxNames = 20;     // of a list
constexpr std::size_t kMaxCharacter = 4;  // bytes of UTF-8

enum class LineBreaks { Kept, Escaped };

/// A character as it is printed.
struct PrintedCharacter {
    std::string text;
    std::size_t width;  // 1, or that of its escape
};

/// The number of bytes of a character by its first one; 1 for a byte that starts none.
std::size_t lengthOf(unsigned char first) {
    if (first >= 0xf0) return 4;
    if (first >= 0xe0) return 3;
    return first >= 0xc2 ? 2 : 1;
}

/// Decodes a well-formed character of UTF-8.
char32_t codePointOf(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    char32_t code = character.size() == 1 ? first : first & (0x7fu >> character.size());
    for (const char byte : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(byte) & 0x3fu);
    return code;
}

bool isControl(char32_t code, LineBreaks breaks) {
    if (code < 0x20) return breaks == LineBreaks::Escaped || (code != '\n' && code != '\t');
    const bool isHighControl = code >= 0x7f && code < 0xa0;
    const bool isDirection = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
                             code == 0x200e || code == 0x200f || code == 0x061c;
    const bool isSeparator = code == 0x2028 || code == 0x2029;
    return isHighControl || isDirection || isSeparator;
}

PrintedCharacter escaped(const char* format, unsigned code) {
    char text[16];
    const int width = std::snprintf(text, sizeof text, format, code);
    return {text, static_cast<std::size_t>(width)};
}

/// Takes the first character, or a byte that is part of none, off the text.
PrintedCharacter takeCharacter(std::string_view& text, LineBreaks breaks) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::string_view character = text.substr(0, lengthOf(first));
    if (!isUtf8(character)) {
        text.remove_prefix(1);
        return escaped("\\x%02x", first);
    }
    text.remove_prefix(character.size());
    const char32_t code = codePointOf(character);
    if (isControl(code, breaks)) return escaped("\\u%04x", static_cast<unsigned>(code));
    return {std::string(character), 1};
}

bool isPlain(char letter) { return letter >= 0x20 && letter < 0x7f; }

/// The longest end of `text` of at most `width` characters.
std::string printedEnd(std::string_view text, std::size_t width) {
    std::size_t from = text.size() - std::min(text.size(), kMaxCharacter * width);
    const auto isContinuation = [&] { return (static_cast<unsigned char>(text[from]) & 0xc0) == 0x80; };
    for (int k = 0; k < 3 && from > 0 && from < text.size() && isContinuation(); ++k) ++from;
    std::vector<PrintedCharacter> characters;
    for (std::string_view rest = text.substr(from); !rest.empty();)
        characters.push_back(takeCharacter(rest, LineBreaks::Escaped));
    std::string end;
    for (auto each = characters.rbegin(); each != characters.rend() && each->width <= width; ++each) {
        end.insert(0, each->text);
        width -= each->width;
    }
    return end;
}

}  // namespace

std::string messageText(double value) {
    std::array<char, 32> text;  // the longest has 25 characters
    const double size = std::abs(value);
    const bool isPlain = size == 0.0 || (size >= 1e-6 && size < 1e15);
    const std::to_chars_result result =
        isPlain ? std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed)
                : std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

std::string roundedText(double value, int digits) {
    std::array<char, 32> text;
    const std::to_chars_result result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), result.ptr};
}

std::string printableText(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        if (isPlain(text[0])) {
            result += text[0];
            text.remove_prefix(1);
        } else {
            result += takeCharacter(text, LineBreaks::Kept).text;
        }
    }
    return result;
}

std::string shownName(std::string_view name) {
    if (name.size() <= kMaxWidth && std::ranges::all_of(name, isPlain)) return std::string(name);
    constexpr std::size_t kHalf = (kMaxWidth - 1) / 2;
    std::string whole, start;
    std::size_t width = 0;
    for (std::string_view rest = name; !rest.empty();) {
        const PrintedCharacter character = takeCharacter(rest, LineBreaks::Escaped);
        width += character.width;
        whole += character.text;
        if (width <= kHalf + 1) start = whole;
        if (width > kMaxWidth) return start + "…" + printedEnd(name, kHalf);
    }
    return whole;
}

std::string quotedName(std::string_view name) { return '"' + shownName(name) + '"'; }

std::string quotedNames(const std::vector<std::string>& names) {
    const std::size_t shown = names.size() > kMaxNames ? kMaxNames - 1 : names.size();
    std::string text;
    for (std::size_t k = 0; k < shown; ++k) text += (k == 0 ? "" : ", ") + quotedName(names[k]);
    return shown == names.size() ? text : text + " and " + std::to_string(names.size() - shown) + " more";
}

std::string quotedPath(const std::filesystem::path& path) {
    std::string text;
    for (std::string_view rest = path.native(); !rest.empty();) text += takeCharacter(rest, LineBreaks::Escaped).text;
    return '"' + text + '"';
}

}  // namespace rubble
