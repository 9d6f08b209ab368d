#include "core/io/system/UnicodeName.h"

#include "core/base/Utf8.h"

#include <utf8proc.h>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>

namespace rubble {
namespace {

constexpr int kFoldedForm = UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_COMPAT | UTF8PROC_CASEFOLD | UTF8PROC_IGNORE;

/// The text after a transformation. It must be well-formed.
std::string mapped(std::string_view text, int options) {
    utf8proc_uint8_t* result = nullptr;
    const utf8proc_ssize_t size =
        utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()), static_cast<utf8proc_ssize_t>(text.size()),
                     &result, static_cast<utf8proc_option_t>(options));
    if (size < 0) throw std::bad_alloc();
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(result, &std::free);
    return {reinterpret_cast<const char*>(result), static_cast<std::size_t>(size)};
}

std::u32string codePointsOf(std::string_view text) {
    std::u32string codes;
    while (!text.empty()) {
        utf8proc_int32_t code = 0;
        const utf8proc_ssize_t size = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                                       static_cast<utf8proc_ssize_t>(text.size()), &code);
        codes += size > 0 ? static_cast<char32_t>(code) : U'\uFFFD';
        text.remove_prefix(size > 0 ? static_cast<std::size_t>(size) : 1);
    }
    return codes;
}

std::string upperCase(std::string_view text) {
    std::u32string codes = codePointsOf(text);
    for (char32_t& code : codes) code = static_cast<char32_t>(utf8proc_toupper(static_cast<utf8proc_int32_t>(code)));
    return utf8Of(codes);
}

}  // namespace

NameCharacter nameCharacterOf(char32_t code) {
    switch (utf8proc_category(static_cast<utf8proc_int32_t>(code))) {
        case UTF8PROC_CATEGORY_ZS: return NameCharacter::Space;
        case UTF8PROC_CATEGORY_CN:
        case UTF8PROC_CATEGORY_CC:
        case UTF8PROC_CATEGORY_CF:
        case UTF8PROC_CATEGORY_CS:
        case UTF8PROC_CATEGORY_CO:
        case UTF8PROC_CATEGORY_ZL:
        case UTF8PROC_CATEGORY_ZP: return NameCharacter::Invisible;
        default: break;
    }
    // Visible by their category, yet drawn as nothing: what comparisons ignore, and U+FFFD.
    const bool isIgnored = mapped(utf8Of({&code, 1}), kFoldedForm).empty();
    return isIgnored || code == U'\uFFFD' ? NameCharacter::Invisible : NameCharacter::Visible;
}

std::u32string composedCodePoints(std::string_view text) {
    return codePointsOf(mapped(wellFormed(text), UTF8PROC_STABLE | UTF8PROC_COMPOSE));
}

std::string utf8Of(std::u32string_view codes) {
    std::string text;
    for (const char32_t code : codes) {
        utf8proc_uint8_t bytes[4];
        const utf8proc_ssize_t size = utf8proc_encode_char(static_cast<utf8proc_int32_t>(code), bytes);
        text.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
    }
    return text;
}

std::size_t nameLength(std::string_view text) {
    std::size_t units = 0;
    for (const char32_t code : codePointsOf(mapped(wellFormed(text), UTF8PROC_STABLE | UTF8PROC_DECOMPOSE)))
        units += code > 0xFFFF ? 2 : 1;
    return std::max(units, text.size());
}

std::string nameKey(std::string_view text) {
    // Windows compares in upper case, one character at a time: "ı" and "i" are both "I" there.
    return mapped(upperCase(mapped(wellFormed(text), kFoldedForm)), kFoldedForm);
}

}  // namespace rubble
