#include "core/asset/project/FragmentColours.h"

#include "core/base/Hash.h"
#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

double encoded(double linear) {
    const double value = std::clamp(linear, 0.0, 1.0);
    // Approximates the sRGB transfer function with a square root, which is the same on every machine.
    return value <= 0.0031308 ? 12.92 * value : 1.13005 * std::sqrt(value - 0.00228) - 0.13448 * value + 0.005719;
}

/// A colour by perceptual lightness, chroma and hue (rad).
/// Source: Ottosson, "A perceptual color space for image processing", 2020.
Colour oklch(double lightness, double chroma, double hue) {
    const double a = chroma * cosine(hue), b = chroma * sine(hue);
    const double l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    const double m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    const double s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {encoded(4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3),
            encoded(-1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3),
            encoded(-0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3)};
}

Colour mix(const Colour& a, const Colour& b, double weight) {
    return {a.red + (b.red - a.red) * weight, a.green + (b.green - a.green) * weight,
            a.blue + (b.blue - a.blue) * weight};
}

}  // namespace

std::uint32_t packed(const Colour& colour) {
    const auto byte = [](double value) {
        return static_cast<std::uint32_t>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5);
    };
    return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

Colour fragmentColour(std::string_view fragmentId) {
    const std::uint64_t bits = contentHash(fragmentId).low;
    const double hue = static_cast<double>(bits & 0xffff) / 65536.0 * 2.0 * std::numbers::pi;
    const double lightness = 0.72 + 0.12 * static_cast<double>(bits >> 16 & 0xff) / 255.0;
    return oklch(lightness, 0.085, hue);
}

Colour seriesColour(std::uint32_t number, double lightness) {
    constexpr double kGoldenAngle = 2.399963229728653;  // rad
    return oklch(lightness, 0.1, kGoldenAngle * number);
}

Colour rampColour(double value) {
    static constexpr std::array<Colour, 6> kStops = {{{0.28, 0.14, 0.46},
                                                      {0.25, 0.29, 0.54},
                                                      {0.17, 0.48, 0.56},
                                                      {0.15, 0.66, 0.52},
                                                      {0.48, 0.82, 0.32},
                                                      {0.99, 0.91, 0.14}}};
    const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    return mix(kStops[below], kStops[below + 1], place - static_cast<double>(below));
}

Colour insideOf(const Colour& outside) {
    const double grey = 0.3 * outside.red + 0.59 * outside.green + 0.11 * outside.blue;
    return mix(mix(outside, {grey, grey, grey}, 0.45), {0.0, 0.0, 0.0}, 0.22);
}

}  // namespace rubble
