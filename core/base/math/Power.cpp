#include "core/base/math/Power.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

// ln 2 in two parts; the product of the first with the exponent of any double is exact.
constexpr double kLn2 = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kInverseLn2 = 0x1.71547652b82fep+0;
constexpr double kMaxExponent = 745.0;  // of e: e^±745 is beyond the range of doubles

/// ln x for x > 0, as the logarithm of a mantissa m in [sqrt(1/2), sqrt(2)), 2 atanh((m - 1) / (m + 1)), plus that of a
/// power of two.
double naturalLogarithm(double x) {
    int twos = 0;
    double mantissa = std::frexp(x, &twos);  // exact
    if (mantissa < 0x1.6a09e667f3bcdp-1) {
        mantissa *= 2.0;
        --twos;
    }
    const double s = (mantissa - 1.0) / (mantissa + 1.0);
    const double square = s * s;  // at most 0.0295: terms from the twelfth on are below half an ulp
    double series = 0.0;
    for (int k = 23; k >= 3; k -= 2) series = square * (1.0 / k + series);
    return twos * kLn2 + (twos * kLn2Low + 2.0 * (s + s * series));
}

/// e^x.
double exponential(double x) {
    const double twos = std::nearbyint(x * kInverseLn2);
    const double rest = (x - twos * kLn2) - twos * kLn2Low;  // at most 0.35
    double series = 1.0;
    for (int k = 14; k >= 1; --k) series = 1.0 + rest / k * series;
    return std::ldexp(series, static_cast<int>(twos));
}

}  // namespace

double power(double base, double exponent) {
    RUBBLE_ASSERT(base >= 0.0 && (base > 0.0 || exponent >= 0.0));
    if (base == 0.0) return exponent == 0.0 ? 1.0 : 0.0;
    return exponential(std::clamp(exponent * naturalLogarithm(base), -kMaxExponent, kMaxExponent));
}

}  // namespace rubble
