#include "core/base/Percentile.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubble {

double percentile(std::vector<double> values, double fraction) {
    RUBBLE_ASSERT(!values.empty() && fraction >= 0.0 && fraction <= 1.0);
    const double rank = std::ceil(fraction * static_cast<double>(values.size()));
    const std::size_t index = rank < 1.0 ? 0 : static_cast<std::size_t>(rank) - 1;
    const auto position = values.begin() + static_cast<std::ptrdiff_t>(std::min(index, values.size() - 1));
    std::nth_element(values.begin(), position, values.end());
    return *position;
}

}  // namespace rubble
