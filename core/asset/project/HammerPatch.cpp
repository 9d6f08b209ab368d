#include "core/asset/project/HammerPatch.h"

#include "core/asset/project/Ranges.h"
#include "core/base/math/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>

namespace rubble {

double patchRadius(const Hammer& hammer) {
    if (hammer.radius) return *hammer.radius;
    constexpr double kSteel = 7850.0;  // kg/m³
    const double volume = glm::length(hammer.impulse) / kHammerSpeed / kSteel;
    const NumberRange& range = rangeOf(ProjectNumber::HammerRadius);
    return std::clamp(power(3.0 * volume / (4.0 * std::numbers::pi), 1.0 / 3.0), range.min, range.max);
}

}  // namespace rubble
