#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Whether the bars of a histogram are equally wide or grow by a constant factor.
enum class HistogramAxis { Linear, Logarithmic };

/// The count of numbers in [min, max), and in [min, max] for the last bar.
struct HistogramBar {
    double min = 0.0;
    double max = 0.0;
    std::uint32_t count = 0;
    std::uint32_t selected = 0;  // of them
};

/// Sorts positive numbers into `bars` bars between the smallest and the largest: a single bar if all are equal, none if
/// there are no numbers. isSelected holds a flag per number. O(n log bars).
std::vector<HistogramBar> histogramOf(std::span<const double> numbers, const std::vector<bool>& isSelected, int bars,
                                      HistogramAxis axis);

}  // namespace rubble
