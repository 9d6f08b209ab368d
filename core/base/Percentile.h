#pragma once

#include <vector>

namespace rubble {

/// The smallest value that at least `fraction` of all values do not exceed (nearest-rank percentile); 0.5 is the
/// median. Requires at least one value and a fraction in [0, 1]. O(n).
double percentile(std::vector<double> values, double fraction);

}  // namespace rubble
