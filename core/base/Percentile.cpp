#include "core/base/Percentile.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubble {

double percentile(std::vector<double> values, double share) {
    RUBBLE_ASSERT(!values.empty() && share >= 0.0 && share <= 1.0);
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const std::size_t index = rank < 1.0 ? 0 : static_cast<std::size_t>(rank) - 1;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::min(index, values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace rubble
