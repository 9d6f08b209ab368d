#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rubble::test {

using RgbePixel = std::array<std::uint8_t, 4>;

/// The pixel that is read as a radiance to within 1/256 of its largest component.
inline RgbePixel rgbeOf(const std::array<double, 3>& radiance) {
    const double largest = std::max({radiance[0], radiance[1], radiance[2]});
    if (largest < 1e-30) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);
    RgbePixel pixel{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
    for (std::size_t k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint8_t>(std::ldexp(radiance[k], 8 - exponent));
    return pixel;
}

/// A Radiance file.
struct RadianceText {
    enum class Encoding { Plain, Older, Newer };
    std::uint32_t width = 0, height = 0;
    std::function<RgbePixel(std::uint32_t x, std::uint32_t y)> pixel;  // y counts from the top
    Encoding encoding = Encoding::Newer;
    std::string variables;       // more lines of the header
    std::string order = "-Y+X";  // signs and axes of lines and of pixels in them
};

/// The run-length encoding of one component: runs of at least three, and literals.
inline void appendComponent(std::string& bytes, const std::vector<std::uint8_t>& values) {
    for (std::size_t at = 0; at < values.size();) {
        const auto runAt = [&](std::size_t from) {
            std::size_t count = 1;
            while (from + count < values.size() && count < 127 && values[from + count] == values[from]) ++count;
            return count;
        };
        if (const std::size_t run = runAt(at); run >= 3) {
            bytes += static_cast<char>(128 + run);
            bytes += static_cast<char>(values[at]);
            at += run;
            continue;
        }
        std::size_t count = 1;
        while (at + count < values.size() && count < 128 && runAt(at + count) < 3) ++count;
        bytes += static_cast<char>(count);
        for (std::size_t k = 0; k < count; ++k) bytes += static_cast<char>(values[at + k]);
        at += count;
    }
}

inline void appendPixel(std::string& bytes, const RgbePixel& pixel) { bytes.append(pixel.begin(), pixel.end()); }

inline void appendLine(std::string& bytes, const std::vector<RgbePixel>& line, RadianceText::Encoding encoding) {
    if (encoding == RadianceText::Encoding::Newer) {
        bytes += {2, 2, static_cast<char>(line.size() >> 8), static_cast<char>(line.size() & 255)};
        for (std::size_t component = 0; component < 4; ++component) {
            std::vector<std::uint8_t> values;
            for (const RgbePixel& pixel : line) values.push_back(pixel[component]);
            appendComponent(bytes, values);
        }
        return;
    }
    for (std::size_t at = 0; at < line.size();) {
        appendPixel(bytes, line[at]);
        std::size_t same = 0;
        while (at + 1 + same < line.size() && line[at + 1 + same] == line[at]) ++same;
        if (encoding == RadianceText::Encoding::Plain || same == 0) {
            ++at;
            continue;
        }
        for (std::size_t rest = same; rest > 0; rest >>= 8)  // the lowest eight bits first
            appendPixel(bytes, {1, 1, 1, static_cast<std::uint8_t>(rest & 255)});
        at += 1 + same;
    }
}

inline std::string radianceFile(const RadianceText& text) {
    const bool isByColumn = text.order[1] == 'X';
    const std::uint32_t lines = isByColumn ? text.width : text.height, length = isByColumn ? text.height : text.width;
    std::string bytes = "#?RADIANCE\n" + text.variables + "FORMAT=32-bit_rle_rgbe\n\n" + text.order.substr(0, 2) + " " +
                        std::to_string(lines) + " " + text.order.substr(2) + " " + std::to_string(length) + "\n";
    const bool isRightToLeft = text.order[isByColumn ? 0 : 2] == '-',
               isBottomUp = text.order[isByColumn ? 2 : 0] == '+';
    for (std::uint32_t k = 0; k < lines; ++k) {
        std::vector<RgbePixel> line;
        for (std::uint32_t j = 0; j < length; ++j) {
            const std::uint32_t x = isByColumn ? k : j, y = isByColumn ? j : k;
            line.push_back(text.pixel(isRightToLeft ? text.width - 1 - x : x, isBottomUp ? text.height - 1 - y : y));
        }
        appendLine(bytes, line, text.encoding);
    }
    return bytes;
}

}  // namespace rubble::test
