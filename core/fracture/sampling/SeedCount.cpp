#include "core/fracture/sampling/SeedCount.h"

#include <algorithm>
#include <cmath>

namespace rubble {

double SeedCount::in(double size, SeedSpace space) const {
    if (by == CountBy::Number) return amount;
    const double exact =
        by == CountBy::Density ? size * amount : size / amount / amount / (space == SeedSpace::Solid ? amount : 1.0);
    return std::max(1.0, std::floor(exact + 0.5));
}

}  // namespace rubble
