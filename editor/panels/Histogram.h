#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// How the bars of a histogram lie on its axis: each of them as wide in numbers, or each as many times as large as the last.
enum class HistogramAxis { Linear, Logarithmic };

/// How many numbers lie from one bound to the next, and how many of them are chosen.
struct HistogramBar {
    double least = 0.0;  // the last bar holds `most`, the others do not
    double most = 0.0;
    std::uint32_t count = 0;
    std::uint32_t chosen = 0;
};

/// Numbers above zero, sorted into at most `bars` bars that share the way from the smallest to the largest; a single one where
/// all are alike, none where there are no numbers. `isChosen`: one mark a number. O(numbers).
std::vector<HistogramBar> histogramOf(std::span<const double> numbers, const std::vector<bool>& isChosen, int bars,
                                      HistogramAxis axis);

}  // namespace rubble
