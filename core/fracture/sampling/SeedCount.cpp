#include "core/fracture/sampling/SeedCount.h"

#include <algorithm>
#include <cmath>

namespace rubble {

double SeedCount::in(double area) const {
    if (by == CountBy::Number) return amount;
    const double exact = by == CountBy::Density ? area * amount : area / amount / amount;
    return std::max(1.0, std::floor(exact + 0.5));
}

}  // namespace rubble
