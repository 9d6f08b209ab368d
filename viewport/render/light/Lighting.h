#pragma once

#include "core/geometry/mesh/TriangleMesh.h"
#include "viewport/render/light/Sky.h"
#include "viewport/render/light/SkyLight.h"
#include "viewport/scene/Camera.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace rubble {

/// The colours of everything but the bodies.
struct Environment {
    glm::vec4 grid, hulls, wires;          // sRGB
    Vec3 backgroundTop, backgroundBottom;  // radiance, of views without a horizon
    Vec3 zenith, horizon, glow{0.0};       // radiance
    Vec3 soil;                             // radiance of the ground in full light
    Vec3 groundKey;                        // the part of that which the key light gives
    bool isDark = false;                   // what is written over it is bright
    bool isConcrete = false;               // the ground
};
/// Where `light` is that of a sky file, the preset and the theme do not matter.
Environment environmentOf(SkyPreset preset, Theme theme, const SkyLight& light);

/// The directions of light and the subpixel offset of an image. Many with different indices are averaged: their mean is
/// lit by the whole sky and by all of the key light, and is antialiased. The sequence is the same on every machine.
struct LightSample {
    int index = 0;
    Vec3 keyDirection;          // towards the light, length 1
    double keyRadius = 0.0;     // of the part of the key light that this sample stands for, of its distance
    std::vector<Vec3> sky;      // directions, evenly spread over the upper hemisphere
    Vec2 pixelOffset{0.0};      // in [-0.5, 0.5)
    double patternPhase = 0.0;  // in [0, 1), of the patterns that spread samples over pixels
};

/// The light of an image by itself: all of the key light, as seen from its centre, and many directions of the sky.
LightSample singleSample(const Sky& sky);
/// The light of the image with an index among many.
/// Source: Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018.
LightSample lightSample(const Sky& sky, int index);

/// The number of sky directions of singleSample(), and of lightSample().
inline constexpr int kSkyDirections = 32, kSampledSkyDirections = 8;

/// The part of the scene that shadow maps hold: a sphere around all bodies, or around what the camera looks at where
/// that is much less. It moves in steps, so that maps seldom change with the camera.
struct LightRegion {
    Vec3 centre{0.0};  // m, in the world
    double radius = 1.0;
    bool operator==(const LightRegion&) const = default;
};
LightRegion lightRegion(const Box3& bounds, const Camera& camera);

}  // namespace rubble
