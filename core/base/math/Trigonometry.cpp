#include "core/base/math/Trigonometry.h"

#include "core/base/Assert.h"

#include <cmath>

namespace rubble {

namespace {

/// angle = quarterTurns · pi/2 + high + low, |high| <= pi/4 up to rounding.
struct ReducedAngle {
    int quarterTurns;  // modulo four
    double high;
    double low;
};

ReducedAngle reduce(double angle) {
    // pi/2 in parts of 33 bits: their products with a number of turns below 2^20 are exact.
    constexpr double kFirst = 0x1.921fb544p+0;
    constexpr double kSecond = 0x1.0b4611a6p-34;
    constexpr double kRest = 0x1.3198a2e037073p-69;
    constexpr double kTurnsPerRadian = 0x1.45f306dc9c883p-1;
    RUBBLE_ASSERT(std::abs(angle) <= kMaxAngle);
    const double turns = std::nearbyint(angle * kTurnsPerRadian);
    const double afterFirst = angle - turns * kFirst;
    const double second = turns * kSecond;
    const double high = afterFirst - second;
    const double bVirtual = afterFirst - high;
    const double lost = (afterFirst - (high + bVirtual)) + (bVirtual - second);
    const double low = lost - turns * kRest;
    // Renormalized: near a multiple of pi/2, `low` is as significant as `high`.
    const double sum = high + low;
    return {static_cast<int>(static_cast<long long>(turns) & 3), sum, (high - sum) + low};
}

double sineNearZero(double x, double tail) {
    constexpr double kS1 = -1.66666666666666324348e-01, kS2 = 8.33333333332248946124e-03,
                     kS3 = -1.98412698298579493134e-04, kS4 = 2.75573137070700676789e-06,
                     kS5 = -2.50507602534068634195e-08, kS6 = 1.58969099521155010221e-10;
    const double z = x * x;
    const double r = kS2 + z * (kS3 + z * kS4) + z * (z * z) * (kS5 + z * kS6);
    const double cube = z * x;
    return x - ((z * (0.5 * tail - cube * r) - tail) - cube * kS1);
}

double cosineNearZero(double x, double tail) {
    constexpr double kC1 = 4.16666666666666019037e-02, kC2 = -1.38888888888741095749e-03,
                     kC3 = 2.48015872894767294178e-05, kC4 = -2.75573143513906633035e-07,
                     kC5 = 2.08757232129817482790e-09, kC6 = -1.13596475577881948265e-11;
    const double z = x * x;
    const double square = z * z;
    const double r = z * (kC1 + z * (kC2 + z * kC3)) + square * square * (kC4 + z * (kC5 + z * kC6));
    const double half = 0.5 * z;
    const double first = 1.0 - half;
    return first + (((1.0 - first) - half) + (z * r - x * tail));
}

double sineOf(const ReducedAngle& angle) {
    switch (angle.quarterTurns) {
        case 0: return sineNearZero(angle.high, angle.low);
        case 1: return cosineNearZero(angle.high, angle.low);
        case 2: return -sineNearZero(angle.high, angle.low);
        default: return -cosineNearZero(angle.high, angle.low);
    }
}

/// The arctangent of a number in [0, 1]: halved until its series is short.
double arcTangent(double tangent) {
    constexpr int kHalvings = 4, kTerms = 7;  // below 0.05
    for (int k = 0; k < kHalvings; ++k) tangent /= 1.0 + std::sqrt(1.0 + tangent * tangent);
    double sum = 0.0;
    for (int k = kTerms; k >= 0; --k) sum = 1.0 / (2 * k + 1) - tangent * tangent * sum;
    return (1 << kHalvings) * tangent * sum;
}

}  // namespace

double sine(double angle) { return sineOf(reduce(angle)); }

double cosine(double angle) {
    ReducedAngle shifted = reduce(angle);
    shifted.quarterTurns = (shifted.quarterTurns + 1) & 3;
    return sineOf(shifted);
}

double angleOf(double y, double x) {
    const double across = std::abs(x), up = std::abs(y);
    if (across == 0.0 && up == 0.0) return 0.0;
    double angle = up <= across ? arcTangent(up / across) : 0.25 * kFullTurn - arcTangent(across / up);
    if (x < 0.0) angle = 0.5 * kFullTurn - angle;
    return y < 0.0 ? -angle : angle;
}

}  // namespace rubble
