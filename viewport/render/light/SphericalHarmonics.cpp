#include "viewport/render/light/SphericalHarmonics.h"

#include "core/base/math/Trigonometry.h"

#include <cmath>

namespace rubble {
namespace {

constexpr int kHeights = 32, kAzimuths = 64;  // of the directions that are summed up
constexpr double kPi = 0.5 * kFullTurn;

/// The polynomials of the basis; each times its factor is orthonormal.
std::array<double, 9> polynomials(Vec3 n) {
    return {1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0, n.x * n.z, n.x * n.x - n.y * n.y};
}

/// The squares of the factors, times what the cosine leaves of each order: 1, 2/3 and 1/4.
constexpr std::array<double, 9> kHarmonicWeights = {
    0.25 / kPi,        0.75 / kPi * 2.0 / 3.0, 0.75 / kPi * 2.0 / 3.0, 0.75 / kPi * 2.0 / 3.0, 3.75 / kPi * 0.25,
    3.75 / kPi * 0.25, 0.3125 / kPi * 0.25,    3.75 / kPi * 0.25,      0.9375 / kPi * 0.25};

}  // namespace

/// Directions of equal solid angles.
SphericalHarmonics diffuseLight(const std::function<Vec3(Vec3)>& radiance) {
    SphericalHarmonics light;
    constexpr double kSolidAngle = kFullTurn / (kHeights * kAzimuths);
    for (int k = 0; k < kHeights; ++k) {
        const double height = (k + 0.5) / kHeights, horizontal = std::sqrt(1.0 - height * height);
        for (int j = 0; j < kAzimuths; ++j) {
            const double azimuth = kFullTurn * (j + 0.5) / kAzimuths;
            const Vec3 direction(horizontal * cosine(azimuth), height, horizontal * sine(azimuth));
            const Vec3 arriving = kSolidAngle * radiance(direction);
            const std::array<double, 9> values = polynomials(direction);
            for (std::size_t i = 0; i < values.size(); ++i)
                light.coefficients[i] += kHarmonicWeights[i] * values[i] * arriving;
        }
    }
    return light;
}

Vec3 valueFor(const SphericalHarmonics& light, Vec3 normal) {
    const std::array<double, 9> values = polynomials(normal);
    Vec3 sum(0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * light.coefficients[i];
    return sum;
}

}  // namespace rubble
