#include "app/importer/files/Rounding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr int kFloatBits = std::numeric_limits<float>::digits;

void addDecimal(double number, DigitCount& count) {
    std::array<char, 32> text;
    const auto format = std::chars_format::scientific;
    const char* end = std::to_chars(text.data(), text.data() + text.size(), std::abs(number), format).ptr;
    const char* mark = std::find(text.data(), const_cast<char*>(end), 'e');
    const auto length = static_cast<int>(mark - text.data());
    int exponent = 0;
    std::from_chars(mark[1] == '+' ? mark + 2 : mark + 1, end, exponent);
    count.add(length == 1 ? 1 : length - 1, exponent);  // without the point
}

void addBinary(float number, DigitCount& count) {
    int exponent = 0;
    const float fraction = std::frexp(std::abs(number), &exponent);  // in [1/2, 1)
    const auto bits = static_cast<std::uint32_t>(std::ldexp(fraction, kFloatBits));
    count.add(kFloatBits - std::countr_zero(bits), exponent - 1);
}

/// The largest integer of some bits.
double mostOf(int bits) { return std::ldexp(1.0, bits) - 1.0; }

/// Whether all numbers, multiples of 1 / (2^bits - 1), are made of integers with `used` bits.
bool areOfBits(std::span<const double> numbers, int bits, int used) {
    const double most = mostOf(bits), mostUsed = mostOf(used);
    const int low = bits - used;
    const auto areAll = [&](auto isMade) {
        return std::ranges::all_of(numbers,
                                   [&](double number) { return isMade(std::llround(std::abs(number) * most)); });
    };
    const auto isShifted = [&](long long whole) { return whole >> low << low == whole; };
    const auto isRepeated = [&](long long whole) {
        const long long upper = whole >> low;
        return (upper << low | upper >> (used - low)) == whole;
    };
    const auto isScaled = [&](long long whole) {
        const double upper = std::round(static_cast<double>(whole) / most * mostUsed);
        return std::llround(upper / mostUsed * most) == whole;
    };
    return areAll(isShifted) || (used >= low && areAll(isRepeated)) || areAll(isScaled);
}

}  // namespace

void DigitCount::Most::add(int count) {
    if (count < digits) return;
    numbers = count == digits ? numbers + 1 : 1;
    digits = count;
}

void DigitCount::add(int significant, int exponent) {
    significant = std::max(significant, exponent + 1);
    m_significant.add(significant);
    m_fraction.add(std::max(significant - 1 - exponent, 0));
    m_maxExponent = m_isEmpty ? exponent : std::max(m_maxExponent, exponent);
    m_isEmpty = false;
}

double DigitCount::step() const {
    if (m_isEmpty) return 0.0;
    const bool isSignificant = m_significant.numbers > m_fraction.numbers;
    return std::pow(m_base, isSignificant ? m_maxExponent + 1 - m_significant.digits : -m_fraction.digits);
}

void RoundingMeter::add(double number) {
    if (number == 0.0 || !std::isfinite(number)) return;
    addDecimal(number, m_decimal);
    const auto single = static_cast<float>(number);
    if (std::isnormal(single)) addBinary(single, m_binary);
    m_largest = std::max(m_largest, std::abs(number));
}

void RoundingMeter::add(std::span<const Vec3> points) {
    for (const Vec3& point : points)
        for (int k = 0; k < 3; ++k) add(point[k]);
}

double RoundingMeter::step() const {
    if (m_largest == 0.0) return 0.0;
    const double single = std::ldexp(1.0, std::ilogb(m_largest) + 1 - kFloatBits);
    return std::max({single, m_decimal.step(), m_binary.step()});
}

double normalizedStep(std::span<const double> numbers, int bits) {
    int used = 1;
    while (used < bits && !areOfBits(numbers, bits, used)) ++used;
    return used < bits ? 1.0 / mostOf(used) + 1.0 / mostOf(bits) : 1.0 / mostOf(bits);  // rounded once or twice
}

double displacementBy(double step, const Mat4& transform) {
    double length = 0.0;  // of all three axes; squares of enormous scales would overflow
    for (int k = 0; k < 3; ++k) length = std::hypot(length, std::hypot(transform[k].x, transform[k].y, transform[k].z));
    return std::min(step / 2.0 * length, std::numeric_limits<double>::max());
}

}  // namespace rubble
