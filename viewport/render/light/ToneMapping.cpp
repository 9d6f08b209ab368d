#include "viewport/render/light/ToneMapping.h"

#include "core/base/math/Power.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFresnel = 0.04;               // of the light, which a glossy surface adds to its colour
constexpr double kCompressed = 0.8 - kFresnel;  // brighter colours are compressed
constexpr double kDesaturation = 0.15;
constexpr double kCurve = 1.0 / (4.0 * kFresnel);  // of the darkest colours

double leastOf(Vec3 colour) { return std::min({colour.x, colour.y, colour.z}); }
double mostOf(Vec3 colour) { return std::max({colour.x, colour.y, colour.z}); }

/// How white a compressed colour becomes.
double whiteness(double peak, double newPeak) { return 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0); }

}  // namespace

double linearOf(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : power((srgb + 0.055) / 1.055, 2.4); }
double srgbOf(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1.0 / 2.4) - 0.055; }
Vec3 linearOf(Vec3 srgb) { return {linearOf(srgb.x), linearOf(srgb.y), linearOf(srgb.z)}; }
Vec3 srgbOf(Vec3 linear) { return {srgbOf(linear.x), srgbOf(linear.y), srgbOf(linear.z)}; }

Vec3 toneMapped(Vec3 radiance) {
    const double least = leastOf(radiance);
    Vec3 colour = radiance - (least < 2.0 * kFresnel ? least - kCurve * least * least : kFresnel);
    const double peak = mostOf(colour);
    if (peak < kCompressed) return colour;
    const double left = 1.0 - kCompressed;
    const double newPeak = 1.0 - left * left / (peak + left - kCompressed);
    return glm::mix(colour * (newPeak / peak), Vec3(newPeak), whiteness(peak, newPeak));
}

Vec3 radianceShownAs(Vec3 displayed) {
    Vec3 colour = displayed;
    const double newPeak = std::min(mostOf(displayed), 0.999);
    if (newPeak >= kCompressed) {
        const double left = 1.0 - kCompressed;
        const double peak = left * left / (1.0 - newPeak) - left + kCompressed;
        const double white = whiteness(peak, newPeak);
        colour = (displayed - newPeak * white) / (1.0 - white) * (peak / newPeak);
    }
    const double least = std::max(leastOf(colour), 0.0);
    const double before = least < kFresnel ? std::sqrt(least / kCurve) : least + kFresnel;
    return colour + (before - least);
}

}  // namespace rubble
