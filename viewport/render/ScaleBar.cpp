#include "viewport/render/ScaleBar.h"

#include "core/base/QuantityText.h"

#include <array>
#include <cmath>
#include <string_view>

namespace rubble {
namespace {

// In points.
constexpr double kBarMargin = 22.0, kTick = 4.0, kLetter = 4.6, kAdvance = 9.0, kOverBar = 11.0;
constexpr double kPen = 0.75, kHalo = 2.0;

/// A glyph as a polyline on a grid of 3 x 5 points, which are lettered row by row from below: "a" is the lower left
/// point, "c" the lower right, "o" the upper right. A blank lifts the pen.
std::string_view glyphOf(char letter) {
    switch (letter) {
        case '0': return "acoma";
        case '1': return "jnb";
        case '2': return "moigac";
        case '5': return "omgica";
        case 'm': return "ag gh hb hi ic";
        case 'c': return "igac";
        case 'k': return "am dk ec";
        default: return "";
    }
}
Vec2 gridPoint(char point) { return Vec2((point - 'a') % 3 - 1, 0.5 * ((point - 'a') / 3)); }

using BarSegment = std::array<Vec2, 2>;
void addLetter(std::vector<BarSegment>& segments, char letter, Vec2 at) {
    const std::string_view glyph = glyphOf(letter);
    for (std::size_t k = 0; k + 1 < glyph.size(); ++k) {
        if (glyph[k] == ' ' || glyph[k + 1] == ' ') continue;
        segments.push_back({at + kLetter * Vec2(0.6, 1.0) * gridPoint(glyph[k]),
                            at + kLetter * Vec2(0.6, 1.0) * gridPoint(glyph[k + 1])});
    }
}

/// The largest number up to `max` that is 1, 2 or 5 times a power of ten.
double roundNumber(double max) {
    const double power = std::pow(10.0, std::floor(std::log10(max)));
    int digit = 1;
    for (const int larger : {2, 5}) {
        if (larger * power <= max * (1.0 + 1e-9)) digit = larger;
    }
    return digit * power;
}

}  // namespace

RoundLength roundLength(double max, const ScaleUnit& unit) {
    const double number = roundNumber(max / unit.metres);
    if (!unit.name.empty()) return {number * unit.metres, roundedNumber(number) + ' ' + unit.name};
    RoundLength length{number, {}};
    const auto setText = [&](double metres, const char* name) {
        length.text = std::to_string(std::llround(length.metres / metres)) + " " + name;
    };
    if (length.metres >= 999.0) {
        setText(1000.0, "km");
    } else if (length.metres >= 0.99) {
        setText(1.0, "m");
    } else if (length.metres >= 0.0099) {
        setText(0.01, "cm");
    } else {
        setText(0.001, "mm");
    }
    return length;
}

ScaleBarLength scaleBarLength(const Camera& camera, ImageSize size, double scale, const ScaleUnit& unit) {
    const double metresPerPoint = metresPerPixel(camera, size) * scale;
    const RoundLength length = roundLength(kMaxScaleBarWidth * metresPerPoint, unit);
    return {length, length.metres / metresPerPoint};
}

std::vector<ScreenLine> scaleBar(const Camera& camera, ImageSize size, double scale, glm::vec3 colour, glm::vec3 halo) {
    const auto [length, wide] = scaleBarLength(camera, size, scale);
    const double end = size.width / scale - kBarMargin, begin = end - wide;
    std::vector<BarSegment> segments{{Vec2(begin, kBarMargin), Vec2(end, kBarMargin)}};
    for (const double x : {begin, end}) segments.push_back({Vec2(x, kBarMargin), Vec2(x, kBarMargin + kTick)});
    double x = 0.5 * (begin + end) - 0.5 * kAdvance * static_cast<double>(length.text.size() - 1);
    for (const char letter : length.text) {
        addLetter(segments, letter, {x, kBarMargin + kOverBar - kTick});
        x += kAdvance;
    }
    std::vector<ScreenLine> lines;
    const auto add = [&](const BarSegment& segment, glm::vec4 paint, double radius) {
        lines.push_back(
            {glm::vec4(glm::dvec4(scale * segment[0], scale * segment[1])), paint, static_cast<float>(scale * radius)});
    };
    for (const BarSegment& segment : segments) add(segment, glm::vec4(halo, 0.55f), kHalo);
    for (const BarSegment& segment : segments) add(segment, glm::vec4(colour, 1.0f), kPen);
    return lines;
}

}  // namespace rubble
