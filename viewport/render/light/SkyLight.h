#pragma once

#include "viewport/render/light/ReflectionMap.h"
#include "viewport/render/light/Sky.h"
#include "viewport/render/light/SphericalHarmonics.h"

namespace rubble {

/// The light that a sky gives to surfaces, apart from the sun.
struct SkyLight {
    Sky sky;
    SphericalHarmonics diffuse;  // from above
    Vec3 sunOnGround{0.0};       // what a white ground reflects of the sun, as the next of the sky
    Vec3 skyOnGround{0.0};
    Vec3 ground{0.0};  // radiance of what is below
    ReflectionMap reflections;
};

/// Computes it, in some 20 ms.
SkyLight skyLightOf(const Sky& sky);

}  // namespace rubble
