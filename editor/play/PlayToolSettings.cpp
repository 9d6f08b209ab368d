#include "editor/play/PlayToolSettings.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kFullSize = 2.0;  // m, from which diagonal on nothing is scaled down
constexpr double kMinScale = 0.05;

double rounded(double value) {
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::round(value / digit) * digit;
}

}  // namespace

PlayToolSettings defaultPlayTools(double diagonal) {
    PlayToolSettings tools;
    if (!(diagonal > 0.0) || diagonal >= kFullSize) return tools;
    const double scale = std::max(kMinScale, diagonal / kFullSize), volume = scale * scale * scale;
    const double side = rounded(scale * tools.projectile.size.x);
    tools.projectile.size = {side, side, side};
    tools.projectile.mass = rounded(volume * tools.projectile.mass);
    tools.hammerImpulse = rounded(volume * tools.hammerImpulse);
    tools.hammerRadius = rounded(scale * tools.hammerRadius);
    tools.blast.impulse = rounded(volume * tools.blast.impulse);
    tools.blast.radius = rounded(scale * tools.blast.radius);
    return tools;
}

}  // namespace rubble
