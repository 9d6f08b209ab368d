#include "core/io/text/XmlText.h"

#include "core/base/Utf8.h"

namespace rubble {

std::string escapedXml(std::string_view text) {
    std::string result;
    for (const char letter : wellFormed(text)) {
        switch (letter) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
        }
    }
    return result;
}

}  // namespace rubble
