#include "core/asset/mesh/FractalNoise.h"

#include "core/base/Random.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxCell = 1e15;  // beyond it doubles are not exact whole numbers

/// In [-1, 1] at a lattice point.
double latticeValue(double x, double y, std::uint64_t randomSeed) {
    const auto number = [](double value) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)); };
    const std::uint64_t bits = mixSeeds(mixSeeds(randomSeed, number(x)), number(y));
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

/// Quintic interpolation: first and second derivative vanish at 0 and 1.
/// Source: Perlin, "Improving Noise", 2002.
double smoothed(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

double valueNoise(Vec2 position, std::uint64_t randomSeed) {
    position = glm::clamp(position, -kMaxCell, kMaxCell);
    const Vec2 cell{std::floor(position.x), std::floor(position.y)};
    const double weightX = smoothed(position.x - cell.x), weightY = smoothed(position.y - cell.y);
    const auto row = [&](double y) {
        const double left = latticeValue(cell.x, y, randomSeed), right = latticeValue(cell.x + 1.0, y, randomSeed);
        return left + weightX * (right - left);
    };
    const double below = row(cell.y), above = row(cell.y + 1.0);
    return below + weightY * (above - below);
}

}  // namespace

double fractalNoise(Vec2 position, std::uint32_t octaves, std::uint64_t randomSeed) {
    double sum = 0.0, amplitude = 1.0, total = 0.0;
    for (std::uint32_t octave = 0; octave < octaves; ++octave) {
        sum += amplitude * valueNoise(position, mixSeeds(randomSeed, octave));
        total += amplitude;
        amplitude /= 2.0;
        position *= 2.0;
    }
    return total > 0.0 ? sum / total : 0.0;
}

}  // namespace rubble
