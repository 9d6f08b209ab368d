#include "editor/panels/Histogram.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// The bounds of bars: the first and the last are exact.
std::vector<double> boundsOf(double least, double most, int bars, HistogramAxis axis) {
    std::vector<double> bounds = {least};
    for (int k = 1; k < bars; ++k) {
        const double share = static_cast<double>(k) / bars;
        bounds.push_back(axis == HistogramAxis::Linear ? least + share * (most - least)
                                                       : least * std::pow(most / least, share));
    }
    bounds.push_back(most);
    return bounds;
}

}  // namespace

std::vector<HistogramBar> histogramOf(std::span<const double> numbers, const std::vector<bool>& isChosen, int bars,
                                      HistogramAxis axis) {
    if (numbers.empty()) return {};
    const auto [least, most] = std::ranges::minmax(numbers);
    const bool isOne = !(most > least * (1.0 + 1e-12));  // alike but for rounding
    const std::vector<double> bounds = boundsOf(least, most, isOne ? 1 : std::max(bars, 1), axis);
    std::vector<HistogramBar> found;
    for (std::size_t k = 0; k + 1 < bounds.size(); ++k) found.push_back({bounds[k], bounds[k + 1]});
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, numbers[k]);
        HistogramBar& bar = found[static_cast<std::size_t>(above - bounds.begin() - 1)];
        ++bar.count;
        if (isChosen[k]) ++bar.chosen;
    }
    return found;
}

}  // namespace rubble
