#pragma once

#include "core/geometry/Vec.h"

#include <string>
#include <string_view>

namespace rubble {

/// The text of an SVG file while it is written: words as they come, numbers rounded to a hundredth of a pixel.
class SvgText {
public:
    SvgText& operator<<(std::string_view text);
    SvgText& operator<<(char letter);
    SvgText& operator<<(double value);
    /// "x y"
    SvgText& operator<<(Vec2 point);

    std::string text() && { return std::move(m_text); }

private:
    std::string m_text;
};

/// Text that may stand in an element or an attribute of XML; control characters become spaces.
std::string escapedXml(std::string_view text);

}  // namespace rubble
