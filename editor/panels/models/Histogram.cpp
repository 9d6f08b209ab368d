#include "editor/panels/models/Histogram.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// The bounds of the bars; the outermost are exactly min and max.
std::vector<double> boundsOf(double min, double max, int bars, HistogramAxis axis) {
    std::vector<double> bounds = {min};
    for (int k = 1; k < bars; ++k) {
        const double fraction = static_cast<double>(k) / bars;
        bounds.push_back(axis == HistogramAxis::Linear ? min + fraction * (max - min)
                                                       : min * std::pow(max / min, fraction));
    }
    bounds.push_back(max);
    return bounds;
}

}  // namespace

std::vector<HistogramBar> histogramOf(std::span<const double> numbers, const std::vector<bool>& isSelected, int bars,
                                      HistogramAxis axis) {
    if (numbers.empty()) return {};
    const auto [min, max] = std::ranges::minmax(numbers);
    const bool isOne = !(max > min * (1.0 + 1e-12));  // equal but for rounding
    const std::vector<double> bounds = boundsOf(min, max, isOne ? 1 : std::max(bars, 1), axis);
    std::vector<HistogramBar> found;
    for (std::size_t k = 0; k + 1 < bounds.size(); ++k) found.push_back({bounds[k], bounds[k + 1]});
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, numbers[k]);
        HistogramBar& bar = found[static_cast<std::size_t>(above - bounds.begin() - 1)];
        ++bar.count;
        if (isSelected[k]) ++bar.selected;
    }
    return found;
}

}  // namespace rubble
