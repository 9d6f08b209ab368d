#pragma once

#include <vector>

namespace rubble {

/// The value that `share` of all, in [0, 1], do not exceed; 0.5: the median. There is at least one value. O(n).
double percentile(std::vector<double> values, double share);

}  // namespace rubble
