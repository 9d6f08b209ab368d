#include "viewport/render/ScaleBar.h"

#include <array>
#include <cmath>
#include <string_view>

namespace rubble {
namespace {

// In points.
constexpr double kLongest = 150.0, kMargin = 22.0, kTick = 4.0, kLetter = 4.6, kAdvance = 9.0, kOverBar = 11.0;
constexpr double kPen = 0.75, kHalo = 2.0;

/// A sign as a chain of places on a grid of 3 x 5, row by row from below, each a letter: "a" is the lower left place, "c" the
/// lower right, "o" the upper right. A blank lifts the pen.
std::string_view chainOf(char letter) {
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
Vec2 placeOf(char place) { return Vec2((place - 'a') % 3 - 1, 0.5 * ((place - 'a') / 3)); }

using Segment = std::array<Vec2, 2>;
void addLetter(std::vector<Segment>& segments, char letter, Vec2 at) {
    const std::string_view chain = chainOf(letter);
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        if (chain[k] == ' ' || chain[k + 1] == ' ') continue;
        segments.push_back(
            {at + kLetter * Vec2(0.6, 1.0) * placeOf(chain[k]), at + kLetter * Vec2(0.6, 1.0) * placeOf(chain[k + 1])});
    }
}

}  // namespace

RoundLength roundLength(double most) {
    double power = std::pow(10.0, std::floor(std::log10(most)));
    int digit = 1;
    for (const int larger : {2, 5}) {
        if (larger * power <= most * (1.0 + 1e-9)) digit = larger;
    }
    RoundLength length{digit * power, {}};
    const auto written = [&](double unit, const char* name) {
        length.text = std::to_string(std::llround(length.metres / unit)) + " " + name;
    };
    if (length.metres >= 999.0) {
        written(1000.0, "km");
    } else if (length.metres >= 0.99) {
        written(1.0, "m");
    } else if (length.metres >= 0.0099) {
        written(0.01, "cm");
    } else {
        written(0.001, "mm");
    }
    return length;
}

std::vector<Stroke> scaleBar(const Camera& camera, PictureSize size, double scale, glm::vec3 colour, glm::vec3 halo) {
    const double metresPerPoint = metresPerPixel(camera, size) * scale;
    const RoundLength length = roundLength(kLongest * metresPerPoint);
    const double wide = length.metres / metresPerPoint, end = size.width / scale - kMargin, begin = end - wide;
    std::vector<Segment> segments{{Vec2(begin, kMargin), Vec2(end, kMargin)}};
    for (const double x : {begin, end}) segments.push_back({Vec2(x, kMargin), Vec2(x, kMargin + kTick)});
    double x = 0.5 * (begin + end) - 0.5 * kAdvance * static_cast<double>(length.text.size() - 1);
    for (const char letter : length.text) {
        addLetter(segments, letter, {x, kMargin + kOverBar - kTick});
        x += kAdvance;
    }
    std::vector<Stroke> strokes;
    const auto add = [&](const Segment& segment, glm::vec4 paint, double radius) {
        strokes.push_back(
            {glm::vec4(glm::dvec4(scale * segment[0], scale * segment[1])), paint, static_cast<float>(scale * radius)});
    };
    for (const Segment& segment : segments) add(segment, glm::vec4(halo, 0.55f), kHalo);
    for (const Segment& segment : segments) add(segment, glm::vec4(colour, 1.0f), kPen);
    return strokes;
}

}  // namespace rubble
