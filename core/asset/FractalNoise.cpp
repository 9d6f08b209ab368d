#include "core/asset/FractalNoise.h"

#include "core/base/Random.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kFarthestCell = 1e15;  // of the lattice, where whole numbers are still told apart

/// In [-1, 1] at a lattice point.
double latticeValue(double x, double y, std::uint64_t randomSeed) {
    const auto number = [](double value) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)); };
    const std::uint64_t bits = mixedWith(mixedWith(randomSeed, number(x)), number(y));
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

/// From 0 to 1 with no slope nor bend at either end.
double smoothed(double share) { return share * share * share * (share * (share * 6.0 - 15.0) + 10.0); }

double valueNoise(Vec2 place, std::uint64_t randomSeed) {
    place = glm::clamp(place, -kFarthestCell, kFarthestCell);
    const Vec2 cell{std::floor(place.x), std::floor(place.y)};
    const double shareX = smoothed(place.x - cell.x), shareY = smoothed(place.y - cell.y);
    const auto row = [&](double y) {
        const double left = latticeValue(cell.x, y, randomSeed), right = latticeValue(cell.x + 1.0, y, randomSeed);
        return left + shareX * (right - left);
    };
    const double below = row(cell.y), above = row(cell.y + 1.0);
    return below + shareY * (above - below);
}

}  // namespace

double fractalNoise(Vec2 place, std::uint32_t octaves, std::uint64_t randomSeed) {
    double sum = 0.0, height = 1.0, total = 0.0;
    for (std::uint32_t octave = 0; octave < octaves; ++octave) {
        sum += height * valueNoise(place, mixedWith(randomSeed, octave));
        total += height;
        height /= 2.0;
        place *= 2.0;
    }
    return total > 0.0 ? sum / total : 0.0;
}

}  // namespace rubble
