#pragma once

#include "core/geometry/predicates/Predicates.h"

#include <cmath>

namespace rubble {

/// A double and a bound of its distance from the exact number that it stands for: a filter that decides most signs
/// before any exact arithmetic. Exact while no intermediate value overflows or underflows.
struct BoundedDouble {
    double value = 0.0;
    double error = 0.0;

    BoundedDouble() = default;
    /// An exact number.
    BoundedDouble(double exact) : value(exact) {}
    BoundedDouble(double rounded, double bound) : value(rounded), error(bound) {}

    /// +1 or -1; 0 if the sign is not known.
    int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }

    friend BoundedDouble operator-(BoundedDouble a) { return {-a.value, a.error}; }
    friend BoundedDouble operator+(BoundedDouble a, BoundedDouble b) {
        const double sum = a.value + b.value;
        return {sum, kWiden * (a.error + b.error + kRounding * std::abs(sum))};
    }
    friend BoundedDouble operator-(BoundedDouble a, BoundedDouble b) { return a + -b; }
    friend BoundedDouble operator*(BoundedDouble a, BoundedDouble b) {
        const double product = a.value * b.value;
        const double magnitude = std::abs(a.value) + a.error;
        return {product, kWiden * (magnitude * b.error + std::abs(b.value) * a.error + kRounding * std::abs(product))};
    }

private:
    static constexpr double kWiden = 1.0 + 8.0 * kRounding;  // covers the rounding of the bound itself
};

}  // namespace rubble
