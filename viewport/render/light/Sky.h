#pragma once

#include "core/geometry/predicates/Vec.h"
#include "viewport/render/light/SkyPreset.h"

#include <vector>

namespace rubble {

/// A soft box or a lamp: a disc of light. It lights and is reflected, but is not seen in the background.
struct SkyLamp {
    Vec3 direction;       // towards its centre, length 1
    double radius = 0.0;  // of its distance
    Vec3 radiance;
    bool operator==(const SkyLamp&) const = default;
};

/// What lights a scene, from infinitely far away. All colours are linear; lights are given as what a white surface that
/// faces them reflects, which is a radiance.
struct Sky {
    Vec3 sunDirection{0.0, 1.0, 0.0};  // towards the sun, length 1: the key light
    Vec3 sunLight{0.0};
    double sunRadius = 0.0;      // of its distance: how soft shadows are
    Vec3 zenith{0.0};            // radiance, as is the next
    Vec3 horizon{0.0};           //
    Vec3 glow{0.0};              // around the sun
    double glowSharpness = 0.0;  // halvings of the glow over a right angle
    Vec3 groundAlbedo{0.0};
    std::vector<SkyLamp> lamps;
    bool operator==(const Sky&) const = default;
};
Sky skyOf(SkyPreset preset, Theme theme);

/// That of the ground outdoors in daylight.
inline constexpr Vec3 kConcreteAlbedo{0.36, 0.355, 0.345};

/// The radiance of the sky alone in a direction of length 1; below the horizon that of the horizon.
Vec3 backgroundRadiance(const Sky& sky, Vec3 direction);
/// The same with its lamps.
Vec3 skyRadiance(const Sky& sky, Vec3 direction);

}  // namespace rubble
