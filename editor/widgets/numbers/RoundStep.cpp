#include "editor/widgets/numbers/RoundStep.h"

#include <cmath>

namespace rubble {

double roundStep(double minimum) {
    const double power = std::pow(10.0, std::floor(std::log10(minimum)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= minimum * (1.0 - 1e-12)) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace rubble
