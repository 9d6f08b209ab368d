#pragma once

#include <cmath>
#include <vector>

namespace rubble {

/// Pearson's sum over (seen - expected)^2 / expected, by the least sum that so many categories exceed once in a hundred
/// times where what is seen follows what is expected: below 1 stands for p > 0.01. Categories of which none is expected
/// must be empty.
/// Source: the approximation of Wilson and Hilferty 1931, within half a per cent from ten categories on.
inline double chiSquareByLimit(const std::vector<double>& seen, const std::vector<double>& expected) {
    constexpr double kNormalAtHundredth = 2.3263;
    double sum = 0.0, categories = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
        if (expected[k] == 0.0 && seen[k] > 0.0) return INFINITY;
        if (expected[k] == 0.0) continue;
        sum += (seen[k] - expected[k]) * (seen[k] - expected[k]) / expected[k];
        categories += 1.0;
    }
    const double freedom = categories - 1.0, variance = 2.0 / (9.0 * freedom);
    return sum / (freedom * std::pow(1.0 - variance + kNormalAtHundredth * std::sqrt(variance), 3.0));
}

}  // namespace rubble
