#include "core/io/media/SvgWriter.h"

#include "core/io/text/NumberText.h"

#include <cmath>

namespace rubble {

SvgWriter& SvgWriter::operator<<(std::string_view text) {
    m_text += text;
    return *this;
}

SvgWriter& SvgWriter::operator<<(char letter) {
    m_text += letter;
    return *this;
}

SvgWriter& SvgWriter::operator<<(double value) {
    appendNumber(m_text, std::round(value * 100.0) / 100.0 + 0.0);  // -0 is written as 0
    return *this;
}

SvgWriter& SvgWriter::operator<<(Vec2 point) { return *this << point.x << ' ' << point.y; }

}  // namespace rubble
