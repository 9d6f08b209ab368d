#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <functional>

namespace rubble {

/// The diffuse light of a radiance over all directions: what a white surface reflects, for each normal, as the first
/// nine spherical harmonics.
/// Source: Ramamoorthi, Hanrahan, "An efficient representation for irradiance environment maps", 2001.
struct SphericalHarmonics {
    std::array<Vec3, 9> coefficients{};  // of 1, y, z, x, xy, yz, 3 z² - 1, xz, x² - y², in this order
    bool operator==(const SphericalHarmonics&) const = default;
};

/// That of a radiance from above; what is below the horizon is dark.
SphericalHarmonics diffuseLight(const std::function<Vec3(Vec3)>& radiance);

/// Its value for a normal of length 1.
Vec3 valueFor(const SphericalHarmonics& light, Vec3 normal);

}  // namespace rubble
