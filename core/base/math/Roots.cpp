#include "core/base/math/Roots.h"

#include "core/base/Assert.h"

#include <cmath>

namespace rubble {

double cubeRoot(double number) {
    RUBBLE_ASSERT(number > 0.0 && std::isfinite(number));
    int exponent = 0;
    double rest = std::frexp(number, &exponent);  // number = rest * 2^exponent, both exact
    const int third = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
    rest = std::ldexp(rest, exponent - 3 * third);  // in [0.5, 4)
    double root = 1.0;
    for (int round = 0; round < 7; ++round) root -= (root * root * root - rest) / (3.0 * root * root);
    return std::ldexp(root, third);
}

}  // namespace rubble
