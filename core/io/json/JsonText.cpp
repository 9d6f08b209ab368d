#include "core/io/json/JsonText.h"

#include "core/base/Utf8.h"

namespace rubble {

void appendJsonText(std::string& json, std::string_view text) {
    if (!isUtf8(text)) return appendJsonText(json, wellFormed(text));
    constexpr const char* kDigits = "0123456789abcdef";
    json += '"';
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        switch (letter) {
            case '"': json += "\\\""; break;
            case '\\': json += "\\\\"; break;
            case '\n': json += "\\n"; break;
            case '\t': json += "\\t"; break;
            default:
                if (code < 0x20) {
                    json += std::string("\\u00") + kDigits[code >> 4] + kDigits[code & 15];
                } else {
                    json += letter;
                }
        }
    }
    json += '"';
}

}  // namespace rubble
