#pragma once

#include "core/geometry/predicates/Vec.h"

#include <string>
#include <string_view>

namespace rubble {

/// Writes the text of an SVG file. Numbers are rounded to a hundredth of a pixel.
class SvgWriter {
public:
    SvgWriter& operator<<(std::string_view text);
    SvgWriter& operator<<(char letter);
    SvgWriter& operator<<(double value);
    /// Writes "x y".
    SvgWriter& operator<<(Vec2 point);

    std::string text() && { return std::move(m_text); }

private:
    std::string m_text;
};

}  // namespace rubble
