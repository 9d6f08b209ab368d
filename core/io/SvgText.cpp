#include "core/io/SvgText.h"

#include "core/io/NumberText.h"

#include <cmath>

namespace rubble {

SvgText& SvgText::operator<<(std::string_view text) {
    m_text += text;
    return *this;
}

SvgText& SvgText::operator<<(char letter) {
    m_text += letter;
    return *this;
}

SvgText& SvgText::operator<<(double value) {
    appendNumber(m_text, std::round(value * 100.0) / 100.0 + 0.0);  // -0 is written as 0
    return *this;
}

SvgText& SvgText::operator<<(Vec2 point) { return *this << point.x << ' ' << point.y; }

std::string escapedXml(std::string_view text) {
    std::string result;
    for (const char letter : text) {
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
