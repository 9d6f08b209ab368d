#include "core/base/QuantityText.h"

#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace rubble {
namespace {

constexpr int kDigits = 4;  // significant

/// A unit, its size in SI units, and the smallest value it is used for.
struct Unit {
    std::string_view name;
    double size;
    double least;
};

// Largest unit first; the last is used for all that is smaller.
constexpr std::array kLengths{Unit{"m", 1.0, 0.1}, Unit{"mm", 1e-3, 1e-4}, Unit{"µm", 1e-6, 0.0}};
constexpr std::array kAreas{Unit{"m²", 1.0, 0.1}, Unit{"cm²", 1e-4, 1e-4}, Unit{"mm²", 1e-6, 0.0}};
constexpr std::array kVolumes{Unit{"m³", 1.0, 1e-3}, Unit{"cm³", 1e-6, 1e-6}, Unit{"mm³", 1e-9, 0.0}};
constexpr std::array kMasses{Unit{"t", 1e3, 1e4}, Unit{"kg", 1.0, 0.1}, Unit{"g", 1e-3, 0.0}};
constexpr std::array kDensities{Unit{"kg/m³", 1.0, 0.0}};
constexpr std::array kTimes{Unit{"s", 1.0, 0.1}, Unit{"ms", 1e-3, 0.0}};
constexpr std::array kSpeeds{Unit{"m/s", 1.0, 0.1}, Unit{"mm/s", 1e-3, 0.0}};
constexpr std::array kForces{Unit{"MN", 1e6, 1e6}, Unit{"kN", 1e3, 1e3}, Unit{"N", 1.0, 0.0}};
constexpr std::array kImpulses{Unit{"kN·s", 1e3, 1e4}, Unit{"N·s", 1.0, 0.0}};
constexpr std::array kEnergies{Unit{"MJ", 1e6, 1e6}, Unit{"kJ", 1e3, 1e3}, Unit{"J", 1.0, 0.0}};
constexpr std::array kPressures{Unit{"GPa", 1e9, 1e9}, Unit{"MPa", 1e6, 1e6}, Unit{"kPa", 1e3, 1e3},
                                Unit{"Pa", 1.0, 0.0}};

std::span<const Unit> unitsOf(QuantityKind kind) {
    switch (kind) {
        case QuantityKind::Length: return kLengths;
        case QuantityKind::Area: return kAreas;
        case QuantityKind::Volume: return kVolumes;
        case QuantityKind::Mass: return kMasses;
        case QuantityKind::Density: return kDensities;
        case QuantityKind::Time: return kTimes;
        case QuantityKind::Speed: return kSpeeds;
        case QuantityKind::Force: return kForces;
        case QuantityKind::Impulse: return kImpulses;
        case QuantityKind::Energy: return kEnergies;
        case QuantityKind::Pressure: return kPressures;
    }
    return kLengths;
}

/// The SI unit itself, in which zero is written.
const Unit& baseUnit(std::span<const Unit> units) {
    for (const Unit& unit : units) {
        if (unit.size == 1.0) return unit;
    }
    return units.front();
}

}  // namespace

ScaledQuantity scaledQuantity(QuantityKind kind, double value) {
    const std::span<const Unit> units = unitsOf(kind);
    if (value == 0.0 || !std::isfinite(value)) return {value, baseUnit(units).name};
    const double size = std::abs(value) * (1.0 + 1e-9);  // 0.1 - 1e-17 is 0.1
    for (const Unit& unit : units) {
        if (size >= unit.least) return {value / unit.size, unit.name, unit.size};
    }
    return {value / units.back().size, units.back().name, units.back().size};
}

std::string roundedNumber(double value) {
    const double size = std::abs(value);
    std::array<char, 40> text;
    char* const begin = text.data();
    char* const end = begin + text.size();
    if (!std::isfinite(value) || size >= 1e15 || (size < 1e-6 && size > 0.0)) {
        return {begin, std::to_chars(begin, end, value, std::chars_format::general, kDigits).ptr};
    }
    if (size >= 1000.0) return {begin, std::to_chars(begin, end, std::round(value), std::chars_format::fixed, 0).ptr};
    // Decimals so that kDigits significant digits remain.
    const int decimals = size == 0.0 ? 0 : kDigits - 1 - static_cast<int>(std::floor(std::log10(size)));
    std::string number(begin, std::to_chars(begin, end, value, std::chars_format::fixed, decimals).ptr);
    if (number.find('.') == std::string::npos) return number;
    while (number.back() == '0') number.pop_back();
    if (number.back() == '.') number.pop_back();
    return number;
}

std::string quantityText(QuantityKind kind, double value) {
    const ScaledQuantity scaled = scaledQuantity(kind, value);
    return roundedNumber(scaled.value) + ' ' + std::string(scaled.unit);
}

std::string countText(std::size_t count, std::string_view singular, std::string_view plural) {
    return std::to_string(count) + ' ' + std::string(count == 1 ? singular : plural);
}

}  // namespace rubble
