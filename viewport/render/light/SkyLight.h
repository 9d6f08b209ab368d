#pragma once

#include "core/base/image/RadianceImage.h"
#include "viewport/render/light/ReflectionMap.h"
#include "viewport/render/light/Sky.h"
#include "viewport/render/light/SphericalHarmonics.h"

#include <memory>

namespace rubble {

/// The light that a sky gives to surfaces, apart from the sun.
struct SkyLight {
    Sky sky;
    SphericalHarmonics diffuse;  // from above
    Vec3 sunOnGround{0.0};       // what a white ground reflects of the sun, as the next of the sky
    Vec3 skyOnGround{0.0};
    Vec3 ground{0.0};  // radiance of what is below
    ReflectionMap reflections;
    std::shared_ptr<const RadianceImage> background;  // what is seen of a sky file, in place of the sky's colours
};

/// Computes it, in some 20 ms.
SkyLight skyLightOf(const Sky& sky);

/// That of the picture of a sky with some light above the horizon, exposed so that it has the mean luminance of the
/// studio. Its brightest region becomes the sun where takeKeyLight() finds one; what the picture has below the horizon
/// gives no light, but the ground does. Takes some 100 ms.
SkyLight skyLightOf(RadianceImage image, const Vec3& groundAlbedo = kConcreteAlbedo);

/// The mean radiance above the horizon, the sun included.
Vec3 meanRadiance(const SkyLight& light);

}  // namespace rubble
